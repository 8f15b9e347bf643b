"""What a user does, wherever that is: bake, make materials, render them, export, and read a file back.

    python session_in_circumstances.py UNPACKED_EXTENSION OUT

Started by test_circumstances.py; OUT gets the exports and report.json.
"""

import json
import locale
import os
import sys
from pathlib import Path

EXTENSION, OUT = map(Path, sys.argv[1:])
locale.setlocale(locale.LC_ALL, "")
sys.path.insert(0, str(EXTENSION))

import bpy  # noqa: E402

from addon import api, export  # noqa: E402
from addon.models import all_models  # noqa: E402
from addon.models.making import exported as exported_as  # noqa: E402
from addon.models.making import made  # noqa: E402
from addon.spectra.readers import read_file  # noqa: E402
from addon.verify import scenes  # noqa: E402


def exported():
    """Write copper in every form, and bake it again from what was written."""
    baked = api.bake("copper", formula="exact")
    record = made(preset="copper", realisation="exact")
    for form, name in (("json", "copper.json"), ("csv", "copper.csv"), ("materialx", "copper.mtlx"),
                       ("spectrum_csv", "spectrum.csv")):
        export.write_text(OUT / name, exported_as(record, form))
    again = api.bake(read_file(OUT / "spectrum.csv"), formula="exact")
    return {"f0": baked.f0, "again": again.f0}


def rendered(model, realisation):
    """Mean colour of a sphere in an even world."""
    scene = scenes.empty_scene(8, samples=4, osl=realisation.startswith("osl"))
    scenes.add_sphere(api.create_material(model, realisation=realisation), 32)
    scenes.set_world(scene, 1.0)
    return scenes.render(scene).mean(axis=(0, 1)).tolist()


report = {"comma": locale.localeconv()["decimal_point"], "exported": exported(),
          "rendered": {f"{model.name} {realisation}": rendered(model.name, realisation)
                       for model in all_models() for realisation in model.realisations},
          "profile": bpy.utils.resource_path("USER")}
(OUT / "report.json").write_text(json.dumps(report), encoding="utf-8")
sys.stdout.flush()
os._exit(0)  # taking Blender down after USD's modules can hang
