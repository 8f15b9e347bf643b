"""Render clear bodies with Mitsuba 3, wavelength by wavelength: the reference that does not share a line with us.

    python -m tools.mitsuba_clear [--scenes plate …] [--samples 1024] [--out tests/data/mitsuba_clear.npz]

Mitsuba's dielectric has one index, so every band of 10 nm is a picture of its own with the dataset's n there; together,
weighed by the observer and D65, they are linear Rec.709. Water in a glass is one picture, of n_d.
"""

import argparse
import json
import tempfile
from pathlib import Path

import mitsuba
import numpy as np

from addon.bake.colour import spectral_weights
from addon.catalogue import presets
from addon.reflectance.transmission import LAMBDA_D
from addon.spectra.observers import WAVELENGTH_NM

from .clear_scenes import SCENES, triangles

OUT = Path(__file__).resolve().parent.parent / "tests" / "data" / "mitsuba_clear.npz"
RESOLUTION, DEPTH, BAND = 48, 26, 10
SAMPLES = {"plate": 256, "prism": 256, "ball": 256, "brilliant": 1024, "water in a glass": 2048}
"""Of each picture: a brilliant's of 256 differ from others of 1024 by a mean CIEDE2000 of 0.8, all of it noise."""
N_D_OF_WATER = 1.333


def bands():
    """(mean wavelengths ``(B,)`` in nm, weights ``(B, 3)``) of 400 to 700 nm; the ends hold what is beyond."""
    weights = spectral_weights()
    number = np.clip((WAVELENGTH_NM - 395.0) // BAND, 0, 30).astype(int)
    size = np.abs(weights).sum(axis=1)
    centres = np.bincount(number, size * WAVELENGTH_NM) / np.bincount(number, size)
    return centres, np.stack([np.bincount(number, weights[:, channel]) for channel in range(3)], axis=1)


def dielectric(inside, outside=1.0):
    """Mitsuba's smooth dielectric."""
    return {"type": "dielectric", "int_ior": float(inside), "ext_ior": float(outside)}


def _mesh(folder, name, corners, faces):
    """A mesh with flat faces, by a file."""
    places, split = np.array(corners)[triangles(faces)].reshape(-1, 3), len(triangles(faces))
    lines = ["ply", "format ascii 1.0", f"element vertex {len(places)}", *(f"property float {axis}" for axis in "xyz"),
             f"element face {split}", "property list uchar int vertex_indices", "end_header",
             *(" ".join(f"{x:.9g}" for x in place) for place in places),
             *(f"3 {3 * i} {3 * i + 1} {3 * i + 2}" for i in range(split))]
    path = Path(folder) / f"{name}.ply"
    path.write_text("\n".join(lines) + "\n")
    return {"type": "ply", "filename": str(path), "face_normals": True}


def render(scene, bsdf_of, resolution, samples, seed):
    """Grey picture, (rows from the bottom, columns), of a Scene whose bodies have the bsdf of (inside, outside)."""
    camera = mitsuba.ScalarTransform4f().look_at(origin=list(scene.eye), target=list(scene.target), up=list(scene.up))
    film = {"type": "hdrfilm", "width": resolution, "height": round(resolution * scene.height), "pixel_format": "rgb",
            "component_format": "float32", "rfilter": {"type": "box"}}
    what = {"type": "scene", "integrator": {"type": "path", "max_depth": DEPTH, "rr_depth": 100},
            "sensor": {"type": "perspective", "fov": scene.fov, "fov_axis": "x", "near_clip": 1e-3, "far_clip": 1e3,
                       "to_world": camera, "film": film, "sampler": {"type": "independent", "sample_count": samples}},
            "sky": {"type": "constant", "radiance": {"type": "rgb", "value": scene.sky}}}
    with tempfile.TemporaryDirectory() as folder:
        for i, body in enumerate(scene.bodies):
            what[f"body{i}"] = {**_mesh(folder, f"body{i}", body.corners, body.faces),
                                "bsdf": bsdf_of(body.inside, body.outside)}
        for i, lamp in enumerate(scene.lamps):
            black = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}}
            shining = {"type": "area", "radiance": {"type": "rgb", "value": lamp.radiance}}
            what[f"lamp{i}"] = {**_mesh(folder, f"lamp{i}", lamp.corners, [(0, 1, 2, 3)]),
                                "bsdf": black, "emitter": shining}
        found = mitsuba.render(mitsuba.load_dict(what), seed=seed)
    return np.array(found, float)[::-1, :, 0]


def spectral(name, samples, resolution=RESOLUTION):
    """Linear Rec.709 of a scene of one material."""
    scene = SCENES[name]()
    centres, weights = bands()
    n = presets.constants(presets.find(scene.material)).at(centres)[0]
    pictures = [render(scene, lambda *_, n=n: dielectric(n), resolution, samples, seed)
                for seed, n in enumerate(n.tolist())]
    return np.einsum("byx,bc->yxc", np.array(pictures), weights)


def nested(name="water in a glass", resolution=2 * RESOLUTION, samples=SAMPLES["water in a glass"]):
    """Grey picture of bodies within each other."""
    scene = SCENES[name]()
    body = float(presets.constants(presets.find(scene.material)).at(1e3 * LAMBDA_D)[0])
    index = {"air": 1.0, "body": body, "inner": N_D_OF_WATER}
    return render(scene, lambda inside, outside: dielectric(index[inside], index[outside]), resolution, samples, 1)


def main():
    """Render and keep them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--samples", type=int, help="of every scene, in place of its own")
    parser.add_argument("--out", type=Path, default=OUT)
    arguments = parser.parse_args()
    mitsuba.set_variant("scalar_rgb")
    mitsuba.set_log_level(mitsuba.LogLevel.Error)
    samples = {name: arguments.samples or SAMPLES[name] for name in arguments.scenes}
    found = {name: spectral(name, samples[name]) if name != "water in a glass" else nested(samples=samples[name])
             for name in arguments.scenes}
    about = {"tool": "tools/mitsuba_clear.py", "renderer": f"Mitsuba {mitsuba.__version__}, scalar_rgb, a picture for "
             f"every {BAND} nm", "samples": samples,
             "datasets": {name: presets.find(SCENES[name]().material).dataset for name in arguments.scenes}}
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(arguments.out, about=json.dumps(about),
                        **{name: picture.astype(np.float32) for name, picture in found.items()})
    print(f"{arguments.out}: {', '.join(found)}")


if __name__ == "__main__":
    main()
