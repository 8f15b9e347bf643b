"""The ball that fits are judged by, against Mitsuba: its plugin "measured" under the same surrounding."""

import os
from pathlib import Path

import balls
import numpy as np
import pytest
from brdf_files import container, rgl_fields

from addon.measured.ball import Ball, ball
from addon.measured.lights import HELD_OUT, LIGHTS
from addon.measured.reading import read_brdf
from addon.models import named

UP = np.array([0.0, 0.0, 1.0])
RESOLUTION, SAMPLES = 16, 8192
MOST = 0.5
"""Mean CIEDE2000 that so many samples leave."""
FOLDER = os.environ.get("FACET_FILM_BRDF_FOLDER", "")
REAL = ("vch_golden_yellow_rgb", "paper_blue_rgb", "cc_iris_purple_gem_rgb") if FOLDER else ()
PAINT = named("cook_torrance").parameters(n=(1.5, 1.7, 2.0), k=(0.0, 0.2, 0.5), specular=0.6, diffuse=(0.5, 0.3, 0.1),
                                          slopes=((0.25, 0.7), (0.5, 0.3)))


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """{name: path}; the file made here is not reciprocal, so that it matters who looks."""
    made = tmp_path_factory.mktemp("brdf") / "made_rgb.bsdf"
    made.write_bytes(container(rgl_fields(
        lambda v, l: named("cook_torrance").evaluate(PAINT, UP, v, l) * (0.5 + v[:, 2:]), 16, 48)))
    return {"made": made, **{name: Path(FOLDER) / f"{name}.bsdf" for name in REAL}}


def by_mitsuba(path, width=256):
    """The ball in the held-out light as Mitsuba renders it, (rows from the bottom, columns, 3)."""
    mitsuba = pytest.importorskip("mitsuba", exc_type=ImportError)
    mitsuba.set_variant("scalar_rgb")
    u, theta = np.meshgrid((np.arange(width) + 0.5) / width * 2.0 * np.pi,
                           (np.arange(width // 2) + 0.5) / (width // 2) * np.pi)
    d = np.stack([np.sin(theta) * np.sin(u), np.cos(theta), -np.sin(theta) * np.cos(u)], axis=-1)
    light = np.repeat(LIGHTS[HELD_OUT](d)[..., None], 3, axis=-1).astype(np.float32)
    film = {"type": "hdrfilm", "width": RESOLUTION, "height": RESOLUTION, "component_format": "float32",
            "rfilter": {"type": "box"}}
    scene = mitsuba.load_dict({
        "type": "scene",
        "integrator": {"type": "direct"},
        "sensor": {"type": "orthographic", "film": film,
                   "to_world": mitsuba.ScalarTransform4f().look_at(origin=[0, 0, 10], target=[0, 0, 0], up=[0, 1, 0]),
                   "sampler": {"type": "independent", "sample_count": SAMPLES}},
        "sphere": {"type": "sphere", "bsdf": {"type": "measured", "filename": str(path)}},
        "light": {"type": "envmap", "bitmap": mitsuba.Bitmap(light)},
    })
    return np.array(mitsuba.render(scene, seed=1), float)[::-1, :, :3]


def difference(path):
    """Mean CIEDE2000 between the two balls."""
    # More rings than fits take: between those, lines across a highlight are straight, which is 0.5 on gloss.
    shown, brdf = ball(48, 96, 64, 64), read_brdf(path).brdf
    image = shown.image(HELD_OUT, shown.of_brdf(brdf))
    ours, inside = balls.pixels_of(image, RESOLUTION)
    exposure = 0.3 / float(shown.mean(image) @ (0.2126, 0.7152, 0.0722))
    return balls.difference(ours, by_mitsuba(path), inside, exposure)


@pytest.mark.parametrize("name", ["made", *REAL])
def test_the_ball_is_what_mitsuba_renders(name, files):
    found = difference(files[name])
    print(f"{name}: CIEDE2000 {found:.2f} from Mitsuba's ball")
    assert found < MOST


@pytest.mark.parametrize("mutant", ["viewer and light exchanged", "without the light's cosine", "mirrored"])
def test_mutants_of_the_ball_are_found(mutant, files, monkeypatch):
    if mutant == "viewer and light exchanged":
        real = Ball.of_brdf
        monkeypatch.setattr(Ball, "of_brdf", lambda self, brdf: real(self, lambda v, l: brdf(l, v)))
    elif mutant == "without the light's cosine":
        real = Ball.of_brdf
        monkeypatch.setattr(Ball, "of_brdf", lambda self, brdf: real(self, brdf) / self.l[:, 2:])
    else:
        monkeypatch.setitem(LIGHTS, HELD_OUT, lambda d, real=LIGHTS[HELD_OUT]: real(d * np.float32([-1, 1, 1])))
        picture = by_mitsuba(files["made"])
        monkeypatch.undo()
        ball.cache_clear()
        monkeypatch.setitem(globals(), "by_mitsuba", lambda _path: picture)
    assert difference(files["made"]) > 2.0 * MOST
