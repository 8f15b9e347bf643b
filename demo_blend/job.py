"""What a figure is made with: sizes and samples to scale, rendering with progress and an estimate, places to write."""

import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

__all__ = ["Figure", "Job", "Clock"]


@dataclass(frozen=True)
class Figure:
    """A picture (or several) that `make figures` makes.

    name     of the picture, and on the command line
    title    what it shows
    seconds  that it took on two cores, for the estimate
    make     function of a Job
    """

    name: str
    title: str
    seconds: float
    make: object


@dataclass
class Clock:
    """How long the rest will take: the figures' known seconds, scaled by how fast this machine has been."""

    planned: float
    begun: float = field(default_factory=time.perf_counter)
    done: float = 0.0
    counted: float = 0.0

    def finished(self, seconds):
        """Count a figure of so many planned seconds as made."""
        self.done += seconds
        self.counted = time.perf_counter() - self.begun

    def left(self):
        """Words for the time that remains."""
        pace = self.counted / self.done if self.done else 1.0
        seconds = max(0.0, self.planned * pace - (time.perf_counter() - self.begun))
        return f"about {seconds / 60:.0f} min left" if seconds >= 90 else f"about {seconds:.0f} s left"


@dataclass
class Job:
    """Where a figure's pictures and scenes go, and how large.

    pictures  folder of the pictures that the documents show
    scenes    folder of the .blend files
    scale     of sizes and samples; 1 is what the documents show
    heading   what stands before each line of progress
    other     the python of an environment with another Blender, or None
    """

    pictures: Path
    scenes: Path
    scale: float = 1.0
    heading: object = None
    other: str | None = None
    generator: str = ""
    written: list = field(default_factory=list)

    def size(self, width, height):
        """A resolution at this job's scale."""
        return tuple(max(16, round(side * self.scale)) for side in (width, height))

    def samples(self, count):
        """Samples a pixel at this job's scale."""
        return max(1, round(count * self.scale))

    def render(self, scene, title):
        """The picture as shown on screen, 8 bits, (rows, columns, 3)."""
        from . import pictures
        with tempfile.TemporaryDirectory() as folder:
            scene.render.image_settings.file_format = "PNG"
            self._render(scene, Path(folder) / "shown.png", title)
            return pictures.read(Path(folder) / "shown.png")

    def render_linear(self, scene, title):
        """The scene-linear picture, float, (rows, columns, 3), top row first."""
        import bpy
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "linear.exr"
            scene.render.image_settings.file_format = "OPEN_EXR"
            scene.render.image_settings.color_depth = "32"
            self._render(scene, path, title)
            image = bpy.data.images.load(str(path))
            pixels = np.empty(len(image.pixels), np.float32)
            image.pixels.foreach_get(pixels)
            width, height = image.size
            bpy.data.images.remove(image)
        return pixels.reshape(height, width, -1)[::-1, :, :3].astype(float)

    def _render(self, scene, path, title):
        from .progress import render_with_progress
        render_with_progress(scene, path, f"{self.heading() if self.heading else ''}{title}", shown=False)

    def write(self, picture, name, **size):
        """Write a picture for the documents; the name says whether .jpg or .png.  `size` as pictures.write has it."""
        from . import pictures
        self.pictures.mkdir(parents=True, exist_ok=True)
        self.written.append(pictures.write(picture, self.pictures / name, self.generator, **size))

    def save_scene(self, name):
        """Save the open file, packed small, to open in Blender."""
        import bpy

        from .progress import blender_silent
        self.scenes.mkdir(parents=True, exist_ok=True)
        path = (self.scenes / f"{name}.blend").resolve()
        with blender_silent():
            bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=True)
        self.written.append(path)
