"""Builds the asset libraries node_groups/blender_4.5 and blender_5.0, on the oldest Blender supported.

    python tools/build_assets.py

Each holds every preset as a material that renders by Fast, every node group but
those of OSL, whose compiled code belongs to one Blender version, and a Fresnel
ramp; with the previews of addon/thumbnails (tools/render_previews.py), catalogues,
tags, author and licence.  There are two, since Blender 5.0 evaluates another
conductor Fresnel than 4.5: n and k are fitted for it.
"""

import sys
import uuid
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

import bpy  # noqa: E402

from addon import api  # noqa: E402
from addon.bake import bake  # noqa: E402
from addon.blender import asset_library, groups, materials  # noqa: E402
from addon.layered_presets import PRESETS  # noqa: E402
from addon.parameters import CookTorrance  # noqa: E402
from addon.spectra import presets  # noqa: E402
from tools.build_groups import source_stamp  # noqa: E402

__all__ = ["AUTHOR", "LICENCE", "CATALOGUES", "build", "catalogue_text", "stamp"]

FILE = "facet_film_assets.blend"
STAMP = "facet_film_assets stamp"
AUTHOR = "The Facet & Film developers"
LICENCE = "CC0-1.0"
THUMBNAILS = ROOT / "addon" / "thumbnails"
KINDS = {
    "metal": "Metals", "alloy": "Alloys", "conductor": "Other Conductors", "semiconductor": "Semiconductors",
    "oxide": "Oxides", "sulphide": "Sulphides", "crystal": "Crystals and Gems", "glass": "Glasses",
    "liquid": "Liquids", "polymer": "Polymers", "figure": "Figures of Cook and Torrance 1982",
}
CATALOGUES = {
    **{kind: f"Cook-Torrance/{title}" for kind, title in KINDS.items()},
    "layered figure": "Layered RGB/Figures of Granier and Heidrich 2003",
    "layered look": "Layered RGB/Looks",
    "group": "Node Groups",
}
"""What an asset is -> its catalogue."""

HEAD = """\
# Catalogues of the Facet & Film assets. Made by tools/build_assets.py.
VERSION 1

"""
NAMESPACE = uuid.UUID("6d1f3c52-9a4e-5b0f-8c39-1f7f0f6f1982")
GROUP_NOTES = {
    "cook_torrance_fast": "Cook and Torrance 1982 by native closures: light-sampled, on every device, and in EEVEE.",
    "cook_torrance_fast_f82": "Cook-Torrance Fast for dielectrics in Blender 4.5, whose conductor Fresnel misses them.",
    "cook_torrance_exact": "The formula of Cook and Torrance 1982 itself, sampled with nodes alone, on every device.",
    "layered_rgb_fast": "Granier and Heidrich's layered RGB model by native closures.",
    "layered_rgb_exact": "The formula of Granier and Heidrich 2003 itself, sampled with nodes alone, on every device.",
    "layer_thickness": "A field of thicknesses for the layered RGB model, and the lower normal tilted along it.",
}


def catalogue_id(kind):
    """The same UUID for the same catalogue, whenever it is built."""
    return str(uuid.uuid5(NAMESPACE, CATALOGUES[kind]))


def catalogue_text():
    """blender_assets.cats.txt: a line "UUID:path:simple name" for each catalogue and those above it."""
    paths = {path: catalogue_id(kind) for kind, path in CATALOGUES.items()}
    for path in list(paths):
        above = path.rpartition("/")[0]
        if above:
            paths.setdefault(above, str(uuid.uuid5(NAMESPACE, above)))
    return HEAD + "".join(f"{identifier}:{path}:{path.replace('/', '-')}\n" for path, identifier in sorted(paths.items()))


def stamp():
    """Changes with the groups, the presets and the previews."""
    import hashlib
    digest = hashlib.sha256(source_stamp().encode())
    for file in (presets.FILE, ROOT / "addon" / "layered_presets.py", *sorted(THUMBNAILS.glob("*.png"))):
        digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


def build(folder, formula):
    """Build one library: every asset for Blenders that evaluate this conductor Fresnel."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    text = bpy.data.texts.new(STAMP)
    text.write(stamp())
    assets = [_cook_torrance(preset, formula) for preset in presets.all_presets().values()]
    assets += [_layered(name) for name in PRESETS]
    assets += [_group(identifier) for identifier in GROUP_NOTES
               if formula != "exact" or identifier != "cook_torrance_fast_f82"]
    assets.append(_ramp("copper"))
    folder.mkdir(parents=True, exist_ok=True)
    bpy.data.libraries.write(str(folder / FILE), {*assets, text}, fake_user=True, compress=True)
    (folder / "blender_assets.cats.txt").write_text(catalogue_text(), encoding="utf-8")
    return len(assets)


def _cook_torrance(preset, formula):
    baked, by_f82 = _baked(preset.name, formula)
    material = bpy.data.materials.new(preset.title)
    materials.apply(material, "cook_torrance", CookTorrance().changed(**baked.cook_torrance_parameters()), "fast",
                    baked.to_dict(), by_f82=by_f82)
    source = f"{baked.source.dataset}: {baked.source.citation}" if preset.dataset else ""
    description = " ".join(filter(None, (preset.note, preset.estimated, source)))
    _as_asset(material, preset.name, preset.kind, description,
              ("Cook-Torrance", KINDS[preset.kind], preset.name, *preset.aliases))
    return material


def _baked(name, formula):
    """As addon.api chooses for a Blender that evaluates this formula."""
    exact = bake(name)
    if formula == "exact":
        return exact, False
    baked = bake(name, formula=formula)
    by_f82 = baked.best == "f82" and baked.conductor.delta_e_2000_max > api.FAR_OFF
    return (exact, True) if by_f82 else (baked, False)


def _layered(name):
    material = api.create_material("layered_rgb", preset=name)
    preset = PRESETS[name]
    _as_asset(material, name, f"layered {preset.kind}", preset.note, ("Layered RGB", "Film", name))
    return material


def _group(identifier):
    group = groups.node_group(identifier)
    _as_asset(group, f"group {identifier}", "group", GROUP_NOTES[identifier], ("Node Group", group.name))
    return group


def _ramp(preset):
    ramp = api.create_fresnel_ramp(preset)
    note = f"The Fresnel curve of {preset} over the angle of view, for any shader that takes a colour."
    _as_asset(ramp, "group fresnel_ramp", "group", note, ("Node Group", "Fresnel", preset))
    return ramp


def _as_asset(datablock, preview, kind, description, tags):
    datablock.asset_mark()
    about = datablock.asset_data
    about.author, about.license, about.copyright = AUTHOR, LICENCE, "2026 " + AUTHOR
    about.description = description
    about.catalog_id = catalogue_id(kind)
    for tag in dict.fromkeys(tags):
        about.tags.new(tag, skip_if_exists=True)
    _set_preview(datablock, THUMBNAILS / f"{preview}.png")


def _set_preview(datablock, path):
    image = bpy.data.images.load(str(path))
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)
    preview = datablock.preview_ensure()
    preview.image_size = image.size
    preview.image_pixels_float.foreach_set(pixels)
    bpy.data.images.remove(image)


if __name__ == "__main__":
    if bpy.app.version[:2] != (4, 5):
        sys.exit("Build the assets on Blender 4.5, whose files every later one opens.")
    for made, fresnel in asset_library.FOLDERS.items():
        count = build(asset_library.ROOT / made, fresnel)
        size = (asset_library.ROOT / made / FILE).stat().st_size
        print(f"{made}: {count} assets, {size / 1024:.0f} kB")
