"""Fits paints, wraps, felts and papers of the RGL-EPFL database, and writes them into the models' presets.json.

    python tools/fit_presets.py FOLDER

FOLDER holds the database's _rgb.bsdf files (Dupuy and Jakob 2018, CC0), which
are not part of this repository.  Presets of the kind "surface" are replaced;
what a model cannot is left out.  The same files give the same presets.
"""

import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from addon import models  # noqa: E402
from addon.measured import fit  # noqa: E402
from addon.measured.fit import POOR  # noqa: E402

KIND = "surface"
MATERIALS = {
    "acrylic_felt_pink": ("felt_pink", "Felt, pink", "fabric", ("pink felt", "Filz, rosa", "粉色毛毡")),
    "acrylic_felt_purple": ("felt_purple", "Felt, purple", "fabric", ("purple felt", "Filz, lila", "紫色毛毡")),
    "acrylic_felt_white": ("felt_white", "Felt, white", "fabric", ("white felt", "Filz, weiß", "白色毛毡")),
    "cardboard": ("cardboard", "Cardboard", "fabric", ("corrugated cardboard", "Pappe", "Karton", "纸板")),
    "paper_blue": ("paper_blue", "Paper, blue", "fabric", ("blue paper", "Papier, blau", "蓝纸")),
    "paper_white": ("paper_white", "Paper, white", "fabric", ("white paper", "Papier, weiß", "白纸")),
    "colodur_azure_4e": ("wall_paint_azure", "Wall paint, azure", "paint",
                         ("Wandfarbe, azur", "天蓝墙漆")),
    "colodur_connemara_4c": ("wall_paint_green", "Wall paint, green", "paint",
                             ("Wandfarbe, grün", "绿色墙漆")),
    "colodur_napoli_4f": ("wall_paint_red", "Wall paint, brick red", "paint", ("Wandfarbe, ziegelrot", "砖红墙漆")),
    "ilm_l3_37_matte": ("matte_paint", "Matte paint", "paint", ("Mattlack", "matt paint", "哑光漆")),
    "ilm_solo_m_68": ("metallic_paint_blue", "Metallic paint, blue", "paint",
                      ("Metalliclack, blau", "蓝色金属漆")),
    "irid_flake_paint2": ("flake_paint", "Flake paint", "paint", ("Effektlack", "珠光漆")),
    "aurora_white": ("wrap_aurora_white", "Vinyl wrap, aurora white", "paint",
                     ("Folie, Aurora-Weiß", "极光白贴膜")),
    "cc_ibiza_sunset": ("wrap_sunset", "Vinyl wrap, colour-shifting sunset", "paint",
                        ("chameleon wrap", "Wechselfarbe, Sonnenuntergang", "变色贴膜")),
    "cc_iris_purple_gem": ("wrap_purple_gem", "Vinyl wrap, colour-shifting purple", "paint",
                           ("chameleon wrap purple", "Wechselfarbe, violett", "紫色变色贴膜")),
    "cc_nothern_aurora": ("wrap_northern_aurora", "Vinyl wrap, colour-shifting aurora", "paint",
                          ("chameleon wrap aurora", "Wechselfarbe, Polarlicht", "极光变色贴膜")),
    "cg_sunflower": ("wrap_gloss_yellow", "Vinyl wrap, gloss yellow", "paint",
                     ("Folie, glänzend gelb", "亮黄贴膜")),
    "chm_light_blue": ("wrap_chrome_light_blue", "Vinyl wrap, matte chrome light blue", "paint",
                       ("Folie, Mattchrom hellblau", "哑光铬浅蓝贴膜")),
    "chm_mint": ("wrap_chrome_mint", "Vinyl wrap, matte chrome mint", "paint",
                 ("Folie, Mattchrom mint", "哑光铬薄荷贴膜")),
    "cm_toxic_green": ("wrap_matte_green", "Vinyl wrap, matte green", "paint",
                       ("Folie, matt grün", "哑光绿贴膜")),
    "satin_purple": ("wrap_pearl_purple", "Vinyl wrap, pearl with a purple sheen", "paint",
                     ("Folie, Perlmutt mit lila Schimmer", "紫光珍珠贴膜")),
    "satin_rosaline": ("wrap_pearl_rose", "Vinyl wrap, pearl with a rose sheen", "paint",
                       ("Folie, Perlmutt mit Roséschimmer", "玫瑰光珍珠贴膜")),
    "vch_dragon_eye_red": ("wrap_chrome_red", "Vinyl wrap, satin chrome red", "paint",
                           ("Folie, Chrom rot", "缎面铬红贴膜")),
    "vch_golden_yellow": ("wrap_chrome_gold", "Vinyl wrap, satin chrome gold", "paint",
                          ("Folie, Chrom gold", "缎面铬金贴膜")),
    "vch_ultra_pink": ("wrap_chrome_pink", "Vinyl wrap, satin chrome pink", "paint",
                       ("Folie, Chrom pink", "缎面铬粉贴膜")),
}
"""File without _rgb.bsdf -> name, title, category and other names of its preset."""
UNSAID = {"thickness"}
"""Parameters that a preset need not say."""


def main(folder):
    """Fit all of MATERIALS and write what a model can."""
    entries = {name: [] for name in models.names()}
    for file, (name, title, category, aliases) in MATERIALS.items():
        found = fit(pathlib.Path(folder) / f"{file}_rgb.bsdf")
        print(f"{name}: {found.fresnel}, {found.mean:.2f}, {found.p95:.1f}: {found.verdict}", flush=True)
        if found.mean <= POOR:
            entries[found.model].append({
                "name": name, "title": title, "category": category, "kind": KIND, "aliases": list(aliases),
                "note": note_of(found), "parameters": parameters_of(found)})
    for model, folder_of_model in models.folders().items():
        write(folder_of_model / "presets.json", entries[model])


def note_of(found):
    """Source, licence and what is left of the difference."""
    return (f"Fitted to {found.title}, RGL-EPFL {found.file} (Dupuy and Jakob 2018; CC0). Under a light that was not "
            f"fitted to, CIEDE2000 is {found.mean:.2f} on average and below {found.p95:.1f} in 95 % of the picture.")


def parameters_of(found):
    """{name: value} as JSON has them."""
    return {name: value for name, value in found.preset().parameters.items() if name not in UNSAID}


def write(file, entries):
    """Put entries in place of a file's own of this kind, a line each."""
    if not file.exists():
        return
    kept = list(kept_records(file.read_text(encoding="utf-8")))
    new = [json.dumps(entry, ensure_ascii=False) for entry in entries]
    file.write_text("[\n" + ",\n".join(kept + new) + "\n]\n", encoding="utf-8")


def kept_records(text):
    """The texts of the records of other kinds, as they stand."""
    at, decode = text.index("{"), json.JSONDecoder().raw_decode
    while at >= 0:
        record, end = decode(text, at)
        if record["kind"] != KIND:
            yield text[at:end]
        at = text.find("{", end)


if __name__ == "__main__":
    main(sys.argv[1])
