"""Hold frosted clear materials against Mitsuba's roughdielectric, by slope and index: what a ball shows and loses.

    python -m tools.compare_rough_glass

Prints a table: the rms difference of two pictures of a frosted ball before bars, without their noise, and the share of
an even white world that is left behind it, by Cycles and by Mitsuba.
"""

import argparse

import mitsuba
import numpy as np

from addon import api
from addon.verify import scenes
from addon.verify.running import _quiet as quiet

from .clear_scenes import SCENES
from .compare_clear import cycles_scene
from .mitsuba_clear import render

__all__ = ["compare", "cycles_ball", "mitsuba_ball"]

SLOPES, INDICES = (0.1, 0.2, 0.35), (1.333, 1.5, 1.785, 2.417)
RESOLUTION, SAMPLES = 32, 1024


def _white(scene):
    return scene._replace(lamps=[], sky=1.0)


def cycles_ball(slope, index, seed, white=False, samples=SAMPLES):
    """Grey picture by Cycles."""
    def material(*_):
        return api.create_material("clear", realisation="fast", roughness=slope**0.5, ior=index)
    scene = cycles_scene("ball", material, RESOLUTION, samples, change=_white if white else None)
    return scenes.render(scene, seed).mean(axis=2)


def mitsuba_ball(slope, index, seed, white=False, samples=SAMPLES):
    """Grey picture by Mitsuba."""
    bsdf = {"type": "roughdielectric", "distribution": "beckmann", "alpha": slope, "int_ior": index, "ext_ior": 1.0}
    scene = SCENES["ball"]()
    return render(_white(scene) if white else scene, lambda *_: bsdf, RESOLUTION, samples, seed)


def compare(slope, index, samples=SAMPLES):
    """(rms difference without noise, what is left of white by Cycles, by Mitsuba) of the middle of the ball."""
    rows = slice(RESOLUTION // 4, -RESOLUTION // 4)
    ours, theirs = (np.array([ball(slope, index, seed, samples=samples)[rows, rows] for seed in (1, 2)])
                    for ball in (cycles_ball, mitsuba_ball))
    first, second = ours - theirs
    left = [float(ball(slope, index, 3, white=True, samples=samples)[rows, rows].mean())
            for ball in (cycles_ball, mitsuba_ball)]
    return float(np.sqrt(max((first * second).mean(), 0.0))), *left


def main():
    """Render, and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--samples", type=int, default=SAMPLES)
    samples = parser.parse_args().samples
    mitsuba.set_variant("scalar_rgb")
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    print("| slope m | index | rms difference | left of white: Cycles | Mitsuba |\n|---|---|---|---|---|")
    for slope in SLOPES:
        for index in INDICES:
            with quiet():
                off, ours, theirs = compare(slope, index, samples)
            print(f"| {slope} | {index} | {off:.3f} | {ours:.3f} | {theirs:.3f} |", flush=True)


if __name__ == "__main__":
    main()
