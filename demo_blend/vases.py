"""Cook and Torrance 1982, figure 6: the copper-coloured plastic vase and the copper vase.

    python -m demo_blend.vases [--out FOLDER] [--samples N] [--width PIXELS]

Bakes copper, gold and vinyl, prints what came out, renders both vases and
saves them with the .blend.
"""

import argparse
from pathlib import Path

from .studio import add_camera, add_sun_of_solid_angle, add_table, new_scene, set_ambient
from .turned import VASE_PROFILE, turned_object

SOLID_ANGLES = (0.0001, 0.0002)
"""Of the paper's two lights, in sr; both have the same radiance Ii, so their irradiances are as 1 to 2."""

AMBIENT_SHARE = 0.01
"""The paper's Iia = 0.01 Ii.  Taken of the lights' irradiance: of their radiance, as printed, the ambient
light would outshine lamps of so small a solid angle three hundredfold."""

VASES = (
    ("6a copper-coloured plastic vase", "figure_6a", "published"),
    ("6b copper vase", "figure_6b", "energy"),
)
"""Title, preset and scale.  At a quarter of the printed scale the plastic's highlights would drown in its
diffuse part; at the full printed scale the metal reflects more light than arrives."""


def build_scene(width, samples):
    """The lit scene without a vase."""
    scene = new_scene((width, width * 5 // 4), samples)
    irradiances = [solid_angle / SOLID_ANGLES[0] * 0.9 for solid_angle in SOLID_ANGLES]
    add_sun_of_solid_angle(scene, SOLID_ANGLES[0], irradiances[0], (-0.9, -0.55, 0.6))
    add_sun_of_solid_angle(scene, SOLID_ANGLES[1], irradiances[1], (0.75, -0.85, 0.95))
    set_ambient(scene, AMBIENT_SHARE * sum(irradiances))
    add_table(scene)
    add_camera(scene, (0.0, -9.5, 2.6), (0.0, 0.0, 1.32))
    return scene


def main(arguments=None):
    """The demo, from the command line."""
    parser = argparse.ArgumentParser(prog="python -m demo_blend.vases", description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=Path("out"), help="folder for pictures and .blend (out)")
    parser.add_argument("--samples", type=int, default=64, help="samples a pixel (64)")
    parser.add_argument("--width", type=int, default=560, help="width of the pictures in pixels (560)")
    options = parser.parse_args(arguments)
    options.out.mkdir(parents=True, exist_ok=True)

    import bpy

    from addon import api
    from addon.cli_text import baked

    from .progress import render_with_progress
    print("Baked from measured optical constants for this Blender, CIE D65, 1931 2° observer:\n")
    for name in ("copper", "gold", "vinyl"):
        print(baked(api.bake(name)) + "\n")

    scene = build_scene(options.width, options.samples)
    vases = [turned_object(title, VASE_PROFILE, api.create_material(preset=preset, name=title, scale=scale))
             for title, preset, scale in VASES]
    for shown in vases:
        for vase in vases:
            vase.hide_render = vase.hide_viewport = vase is not shown
        path = (options.out / f"figure_{shown.name.split()[0]}.png").resolve()
        render_with_progress(scene, path, f"Figure {shown.name}")
    blend = (options.out / "figure_6.blend").resolve()
    bpy.ops.wm.save_as_mainfile(filepath=str(blend), compress=True)
    print(f"Scene: {blend}")


if __name__ == "__main__":
    main()
