"""The probes of addon.verify, as the tests use them: with the statistics, and pictures of what failed."""

from pathlib import Path

import bpy
import numpy as np

from addon.verify.scenes import *  # noqa: F403
from addon.verify.statistics import ZTest, relative_rms, z_test  # noqa: F401

FAILURES = Path(__file__).resolve().parents[2] / "out" / "failed_probes"


def save_failure(name, reference, picture):
    """Keep reference, render and difference of a failed comparison side by side; returns the file's path."""
    FAILURES.mkdir(parents=True, exist_ok=True)
    pictures = [reference, picture, np.abs(picture - reference)]
    strip = np.concatenate([np.nan_to_num(p) for p in pictures], axis=1)
    height, width = strip.shape[:2]
    image = bpy.data.images.new(name, width, height, float_buffer=True)
    image.pixels.foreach_set(np.concatenate([strip, np.ones((height, width, 1))], axis=2).astype(np.float32).ravel())
    image.filepath_raw = str(FAILURES / f"{name}.exr")
    image.file_format = "OPEN_EXR"
    image.save()
    bpy.data.images.remove(image)
    return FAILURES / f"{name}.exr"
