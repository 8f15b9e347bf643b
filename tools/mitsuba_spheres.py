"""Render spheres of measured metals with Mitsuba 3, spectrally: the reference that does not share a line with us.

    python tools/mitsuba_spheres.py [--metals copper …] [--out tests/data/mitsuba_spheres.npz]

Each metal's n and k at every nm, a rough conductor with Beckmann's distribution of rms slope 0.2, seen from
above under an even sky and under a sun at 45°, both D65. Colours are linear Rec.709, a perfect reflector in
the sky 1. Mitsuba draws few wavelengths a sample, which is noise of colour; a perfect reflector drawn with the
same random numbers has the same noise, so the metal over it, times it without noise (from the RGB variant), has
next to none.
"""

import argparse
import json
from pathlib import Path

import mitsuba
import numpy as np

from addon.bake.colour import rgb_to_xyz
from addon.bake.reflected import reflect

METALS = ("copper", "silver", "aluminium", "iron", "nickel", "chromium", "titanium", "platinum", "palladium", "zinc",
          "magnesium", "tungsten", "brass", "gold")
SLOPE, RESOLUTION, SAMPLES = 0.2, 32, 4096
SUN_ANGLE = np.radians(45.0)
LIGHTS = ("sky", "sun")
OUT = Path(__file__).resolve().parent.parent / "tests" / "data" / "mitsuba_spheres.npz"


def spectrum(values):
    """A spectrum at every nm from 360 to 780."""
    return {"type": "regular", "wavelength_min": 360.0, "wavelength_max": 780.0,
            "values": ", ".join(f"{value:.7g}" for value in values)}


def conductor(n, k):
    """Mitsuba's rough conductor of these spectra."""
    return {"type": "roughconductor", "distribution": "beckmann", "alpha": SLOPE, "eta": spectrum(n), "k": spectrum(k)}


PERFECT = {"type": "roughconductor", "distribution": "beckmann", "alpha": SLOPE, "material": "none"}
EMITTERS = {
    "sky": {"type": "constant", "radiance": {"type": "d65"}},
    "sun": {"type": "directional", "direction": [-float(np.sin(SUN_ANGLE)), 0.0, -float(np.cos(SUN_ANGLE))],
            "irradiance": {"type": "d65"}},
}


def render(bsdf, light, samples=SAMPLES, resolution=RESOLUTION):
    """XYZ of the sphere, (rows from the bottom, columns, 3)."""
    transform = mitsuba.ScalarTransform4f().look_at(origin=[0, 0, 10], target=[0, 0, 0], up=[0, 1, 0])
    film = {"type": "hdrfilm", "width": resolution, "height": resolution, "pixel_format": "xyz",
            "component_format": "float32", "rfilter": {"type": "box"}}
    by_lamps = int(light == "sun")
    scene = mitsuba.load_dict({
        "type": "scene",
        "integrator": {"type": "direct", "emitter_samples": by_lamps, "bsdf_samples": 1 - by_lamps},
        "sensor": {"type": "orthographic", "to_world": transform, "film": film,
                   "sampler": {"type": "independent", "sample_count": samples}},
        "sphere": {"type": "sphere", "radius": 1.0, "bsdf": bsdf},
        "light": EMITTERS[light],
    })
    return np.array(mitsuba.render(scene, seed=1), float)[::-1]


def spheres(metals, samples=SAMPLES, resolution=RESOLUTION):
    """{metal: {light: linear Rec.709}}, and under "perfect" the reflector without noise."""
    mitsuba.set_variant("scalar_rgb")
    clean = {light: render(PERFECT, light, samples, resolution) for light in LIGHTS}
    mitsuba.set_variant("scalar_spectral")
    noisy = {light: render(PERFECT, light, samples, resolution) for light in LIGHTS}
    to_rgb = np.linalg.inv(rgb_to_xyz("Rec.709"))
    found = {"perfect": {light: clean[light] @ to_rgb.T for light in LIGHTS}}
    for metal in metals:
        mirror = reflect(metal)
        found[metal] = {}
        for light in LIGHTS:
            picture = render(conductor(mirror.n, mirror.k), light, samples, resolution)
            ratio = np.divide(picture, noisy[light], out=np.zeros_like(picture), where=noisy[light] > 0.0)
            found[metal][light] = (ratio * clean[light]) @ to_rgb.T
    return found


def main():
    """Render and keep them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--metals", nargs="*", default=METALS)
    parser.add_argument("--out", type=Path, default=OUT)
    arguments = parser.parse_args()
    found = spheres(arguments.metals)
    about = {"tool": "tools/mitsuba_spheres.py", "renderer": f"Mitsuba {mitsuba.__version__}, scalar_spectral",
             "slope": SLOPE, "samples": SAMPLES, "sun_angle": float(np.degrees(SUN_ANGLE)),
             "datasets": {metal: reflect(metal).constants.dataset for metal in arguments.metals}}
    arrays = {f"{metal}/{light}": picture.astype(np.float32)
              for metal, lights in found.items() for light, picture in lights.items()}
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(arguments.out, about=json.dumps(about), **arrays)
    print(f"{arguments.out}: {len(arguments.metals)} metals")


if __name__ == "__main__":
    main()
