"""Builds the asset library node_groups/assets, where it is not there or what it is made of has changed.

    python tools/build_assets.py [--again]

It holds every preset but near duplicates as a material that renders by Standard; every node group of the Add menu but
those of OSL, whose compiled code belongs to one Blender version, and a Fresnel ramp. A film whose image and copy of a
group no other shares would weigh 80 kB: the library holds a stand-in, which the extension bakes when it is brought in.
All have the previews of addon/thumbnails (tools/render_previews.py), catalogues, tags, author and licence.  n and k are
for the exact conductor Fresnel; in Blender 4.5, which evaluates another, the extension bakes again what is brought in.
"""

import argparse
import sys
import time
import uuid
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from addon.blender.assets.names import asset_name  # noqa: E402
from addon.catalogue import presets  # noqa: E402
from addon.catalogue.categories import CATEGORIES  # noqa: E402
from addon.catalogue.entries import THUMBNAILS, entries, thumbnail  # noqa: E402
from addon.models import named  # noqa: E402
from tools import packed_blend, stamps  # noqa: E402

__all__ = ["AUTHOR", "CATALOGUES", "FILE", "LICENCE", "build", "catalogue_text", "ensure", "held", "shown"]

FOLDER = ROOT / "node_groups" / "assets"
FILE = FOLDER / "facet_film_assets.blend"
STAMP = FOLDER / "stamp.json"
CATALOGUE_FILE = FOLDER / "blender_assets.cats.txt"
AUTHOR = "The Facet & Film developers"
LICENCE = "CC0-1.0"
PREVIEW, LEVELS = 96, 31
"""Of an asset's preview: pixels across, as a tile of the shelf has, and steps of a channel.  The pictures of all
assets are most of the library; larger ones are in addon/thumbnails.
"""
ALIKE, MOST = 0.05, 0.6
"""How near to the usual pixel one counts as the same, and in what share of the pictures it has to, to be the floor."""
GROUPS = "group"
CATALOGUES = {**CATEGORIES, GROUPS: "Node Groups"}
"""What an asset is -> its catalogue."""

HEAD = """\
# Catalogues of the Facet & Film assets. Made by tools/build_assets.py.
VERSION 1

"""
NAMESPACE = uuid.UUID("6d1f3c52-9a4e-5b0f-8c39-1f7f0f6f1982")


def catalogue_id(kind):
    """The same UUID for the same catalogue, whenever it is built."""
    return str(uuid.uuid5(NAMESPACE, CATALOGUES[kind]))


def catalogue_text():
    """blender_assets.cats.txt: a line "UUID:path:simple name" for each catalogue."""
    return HEAD + "".join(f"{catalogue_id(kind)}:{path}:{path.replace('/', '-')}\n"
                          for kind, path in sorted(CATALOGUES.items(), key=lambda item: item[1]))


def ensure(again=False):
    """Build the library unless it is current; whether it was built."""
    if not again and FILE.exists() and stamps.is_current(STAMP):
        return False
    start = time.perf_counter()
    count = build(FILE)
    data = {*(ROOT / "addon" / "models").glob("*/presets.json"), *(ROOT / "addon" / "spectra" / "data").iterdir(),
            *THUMBNAILS.iterdir()}
    stamps.write(STAMP, stamps.loaded_sources() | data)
    took, size = time.perf_counter() - start, FILE.stat().st_size / 1024
    print(f"{count} assets built in {took:.0f} s, {size:.0f} kB", flush=True)
    return True


def shown():
    """The presets that have a picture of their own: near duplicates stand under their material, and are searched."""
    return [presets.find(entry.name) for entry in entries().values() if not entry.variant_of]


def held():
    """The presets that the library holds whole."""
    everything = shown()
    of_words = {preset.name: _words(preset) for preset in everything}
    shared = Counter(of_words.values())
    return [preset for preset in everything if of_words[preset.name] is None or shared[of_words[preset.name]] > 1]


def _words(preset):
    """What a preset is made of, where its group shows an image of it; else None."""
    model = named(preset.model)
    return preset.parameters.get(model.made_of) if model.picture else None


def build(file):
    """Build the library into a file, and its catalogues beside it; how many assets it has."""
    import bpy

    from addon import api
    from addon.blender.datablocks import groups, materials
    from addon.models.making import made
    bpy.ops.wm.read_factory_settings(use_empty=True)
    assets = []
    everything, whole = shown(), set(held())
    pictures = _previews([*(preset.name for preset in everything), *(f"group {group.identifier}"
                          for group in groups.all_groups()), "group fresnel_ramp"])
    for number, preset in enumerate(everything, 1):
        record = made(preset=preset.name)
        material = materials.create(record, asset_name(preset)) if preset in whole else _stand_in(record, preset)
        _as_asset(material, pictures.get(preset.name), preset.category, _description(preset, record),
                  (*CATALOGUES[preset.category].split("/"), preset.name, *preset.aliases))
        assets.append(material)
        if number % 50 == 0:
            print(f"{number} of {len(everything)} materials", flush=True)
    for group in groups.all_groups():
        if group.in_menu and not group.osl:
            tree = groups.node_group(group.identifier)
            _as_asset(tree, pictures.get(f"group {group.identifier}"), GROUPS, group.summary + ".",
                      ("Node Group", group.name))
            assets.append(tree)
    ramp = api.create_fresnel_ramp("copper")
    note = "The Fresnel curve of copper over the angle of view, for any shader that takes a colour."
    _as_asset(ramp, pictures.get("group fresnel_ramp"), GROUPS, note, ("Node Group", "Fresnel", "copper"))
    assets.append(ramp)
    file.parent.mkdir(parents=True, exist_ok=True)
    packed_blend.write(file, set(assets))
    CATALOGUE_FILE.write_text(catalogue_text(), encoding="utf-8")
    return len(assets)


def _stand_in(record, preset):
    """A material that says what it is, but shows what its model's defaults do."""
    from addon.blender.assets.imported import STAND_IN_KEY
    from addon.blender.datablocks import materials
    from addon.models.making import made
    material = materials.create(made(record.model), asset_name(preset))
    material[materials.RECORD_KEY], material[STAND_IN_KEY] = record.to_json(), True
    return material


def _description(preset, record):
    source = record.baked.get("source") if preset.dataset else None
    cited = f"{source['dataset']}: {source['citation']}" if source else ""
    return " ".join(filter(None, (preset.note, preset.estimated, cited)))


def _as_asset(datablock, pixels, kind, description, tags):
    datablock.asset_mark()
    about = datablock.asset_data
    about.author, about.license, about.copyright = AUTHOR, LICENCE, "2026 " + AUTHOR
    about.description = description
    about.catalog_id = catalogue_id(kind)
    for tag in dict.fromkeys(tags):
        about.tags.new(tag, skip_if_exists=True)
    if pixels is not None:
        shown_as = datablock.preview_ensure()
        shown_as.image_size = pixels.shape[1::-1]
        shown_as.image_pixels_float.foreach_set(pixels.astype("float32").ravel())


def _previews(names):
    """{name: pixels ``(PREVIEW, PREVIEW, 4)``, bottom row first} of those that there are, in LEVELS steps.

    Where nearly all show the floor they get the same floor, which takes the room of one.
    """
    import numpy as np
    there = [name for name in names if thumbnail(name).exists()]
    pictures = np.stack([_picture(thumbnail(name)) for name in there])
    usual = np.median(pictures, axis=0)
    alike = np.abs(pictures - usual).max(axis=-1, keepdims=True) < ALIKE
    floor = alike.mean(axis=0) > MOST
    pictures = np.where(floor & alike, usual, pictures)
    return dict(zip(there, np.round(pictures * LEVELS) / LEVELS))


def _picture(path):
    """A picture of PREVIEW pixels across and high."""
    import bpy
    import numpy as np
    image = bpy.data.images.load(str(path))
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)
    pixels = pixels.reshape(image.size[1], image.size[0], 4)
    bpy.data.images.remove(image)
    smaller = _shares(len(pixels)) @ pixels.reshape(len(pixels), -1)
    smaller = smaller.reshape(PREVIEW, pixels.shape[1], 4)
    return np.einsum("ij,kjl->kil", _shares(pixels.shape[1]), smaller).astype(np.float32)


def _shares(count):
    """How much of each of `count` pixels is in each of PREVIEW ones beside each other, ``(PREVIEW, count)``."""
    import numpy as np
    ends = np.arange(PREVIEW + 1)[:, None] * count / PREVIEW
    inside = np.clip(ends - np.arange(count), 0.0, 1.0)
    return (inside[1:] - inside[:-1]) * PREVIEW / count


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--again", action="store_true", help="build even what is current")
    ensure(parser.parse_args().again)
