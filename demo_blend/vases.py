"""Cook and Torrance 1982, figure 6: the copper-coloured plastic vase and the copper vase.

    python -m demo_blend.vases [--out FOLDER] [--scale SHARE]

Bakes copper, gold and vinyl, prints what came out, renders both vases and
saves them with the .blend.
"""

import argparse
from pathlib import Path

from .job import Figure, Job
from .pictures import labelled, row
from .studio import add_camera, add_cove, add_sun_of_solid_angle, new_scene, set_ambient
from .turned import VASE_PROFILE, turned_object

SOLID_ANGLES = (0.0001, 0.0002)
"""Of the paper's two lights, in sr; both have the same radiance Ii, so their irradiances are as 1 to 2."""

TOWARDS = ((-0.95, -0.75, 0.42), (0.62, -0.95, 0.62))
"""Where the two lights stand; the paper does not say.  Low ones, so that the lip's shadow stays on the neck."""

AMBIENT_SHARE = 0.03
"""Radiance from all around over the lights' irradiance.  The paper's Iia = 0.01 Ii is a share of their radiance, and
would outshine lamps of so small a solid angle a hundredfold."""

BRIGHTNESS = 0.72
"""Irradiance from the brighter light, so that the copper's highlight just reaches white: the paper scales so too."""

VASES = (
    ("6a", "copper-coloured plastic", "figure_6a", "published"),
    ("6b", "copper", "figure_6b", "energy"),
)
"""Name, title, preset and scale.  At a quarter of the printed scale the plastic's highlights would
drown in its diffuse part; at the full printed scale the metal reflects more light than arrives."""


def paper_scene(job, width, height, samples):
    """The paper's lights and ambient term, a backdrop and a camera, without a vase."""
    scene = new_scene(job.size(width, height), job.samples(samples), denoise=True, noise=0.02)
    irradiances = [BRIGHTNESS * solid_angle / SOLID_ANGLES[1] for solid_angle in SOLID_ANGLES]
    for towards, solid_angle, irradiance in zip(TOWARDS, SOLID_ANGLES, irradiances):
        add_sun_of_solid_angle(scene, solid_angle, irradiance, towards)
    set_ambient(scene, AMBIENT_SHARE * sum(irradiances))
    add_cove(scene, (0.10, 0.105, 0.12))
    add_camera(scene, (0.0, -9.4, 2.4), (0.0, 0.0, 1.33))
    return scene


def figure_6(job):
    """Both vases side by side, and a scene with the two."""
    from addon import api
    scene = paper_scene(job, 520, 680, 48)
    vases = [turned_object(f"Figure {name}", VASE_PROFILE,
                           api.create_material(preset=preset, name=title, scale=scale))
             for name, title, preset, scale in VASES]
    shown = []
    for vase, (name, title, _, _) in zip(vases, VASES):
        for other in vases:
            other.hide_render = other.hide_viewport = other is not vase
        shown.append(labelled(job.render(scene, f"figure {name}, {title}"), f"{name}  {title}"))
    job.write(row(shown), "vases_6.jpg")
    job.save_scene("vases_6")


FIGURES = (Figure("vases_6", "Cook and Torrance, figure 6: plastic and copper", 70.0, figure_6),)


def main(arguments=None):
    """The demo, from the command line."""
    parser = argparse.ArgumentParser(prog="python -m demo_blend.vases", description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=Path("out"), help="folder for pictures and .blend (out)")
    parser.add_argument("--scale", type=float, default=1.0, help="of the picture's size and samples (1)")
    options = parser.parse_args(arguments)

    from addon import api
    from addon.shell.text import baked
    print("Baked from measured optical constants for this Blender, CIE D65, 1931 2° observer:\n")
    for name in ("copper", "gold", "vinyl"):
        print(baked(api.bake(name)) + "\n")
    job = Job(options.out, options.out, options.scale, generator="demo_blend/vases.py")
    figure_6(job)
    for path in job.written:
        print(path)


if __name__ == "__main__":
    main()
