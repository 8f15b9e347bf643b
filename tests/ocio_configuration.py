"""A real OpenColorIO configuration of one's own: scene-linear is what one likes, and no name is Blender's."""

import sys

import numpy as np

__all__ = ["P3", "AP1", "write_configuration"]

P3 = ((0.680, 0.320), (0.265, 0.690), (0.150, 0.060)), (0.3127, 0.3290)
"""Chromaticities of P3's primaries, and of D65."""
AP1 = "ACEScg"


def write_configuration(path, linear, opencolorio):
    """Write a configuration whose scene-linear space is P3's or ACEScg, and whose data space is called "Raw".

    path         of the file
    linear       P3 or AP1
    opencolorio  the module PyOpenColorIO
    """
    config = opencolorio.Config.CreateRaw()
    config.setMajorVersion(2)
    config.setMinorVersion(1)
    for name in ("Raw", "raw"):
        config.removeColorSpace(name)
    add = _adder(config, opencolorio)
    add("XYZ of D65", None)
    from_ap0 = opencolorio.BuiltinTransform("UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD")
    add("Archive", from_ap0)
    if linear == AP1:
        add("Plate", opencolorio.BuiltinTransform("ACEScg_to_ACES2065-1"), from_ap0)
    else:
        add("Plate", _matrix(linear, opencolorio))
    add("Screen", opencolorio.MatrixTransform(), srgb=True)
    config.addColorSpace(opencolorio.ColorSpace(name="Raw", isData=True))
    for role, name in (("scene_linear", "Plate"), ("default", "Plate"), ("data", "Raw"), ("color_picking", "Screen"),
                       ("default_byte", "Screen"), ("default_float", "Plate"), ("default_sequencer", "Screen"),
                       ("texture_paint", "Screen"), ("aces_interchange", "Archive"),
                       ("cie_xyz_d65_interchange", "XYZ of D65")):
        config.setRole(role, name)
    config.addDisplayView("Desk", "Plain", "Screen")
    config.validate()
    path.write_text(config.serialize(), encoding="utf-8")


def _adder(config, opencolorio):
    """A function that adds a space by its transforms to XYZ of D65, the reference."""
    srgb_to_xyz = _matrix((((0.64, 0.33), (0.30, 0.60), (0.15, 0.06)), (0.3127, 0.3290)), opencolorio)

    def add(name, first, *others, srgb=False):
        space = opencolorio.ColorSpace(name=name, bitDepth=opencolorio.BIT_DEPTH_F32)
        if srgb:
            curve = opencolorio.ExponentWithLinearTransform(gamma=[2.4] * 3 + [1.0], offset=[0.055] * 3 + [0.0])
            first, others = curve, (srgb_to_xyz,)
        steps = [step for step in (first, *others) if step is not None]
        if steps:
            space.setTransform(opencolorio.GroupTransform(steps), opencolorio.COLORSPACE_DIR_TO_REFERENCE)
        config.addColorSpace(space)
    return add


def _matrix(chromaticities, opencolorio):
    primaries, white = chromaticities
    columns = np.array([(x / y, 1.0, (1.0 - x - y) / y) for x, y in primaries]).T
    x, y = white
    whole = np.eye(4)
    whole[:3, :3] = columns * np.linalg.solve(columns, (x / y, 1.0, (1.0 - x - y) / y))
    return opencolorio.MatrixTransform(whole.ravel().tolist())


if __name__ == "__main__":
    from pathlib import Path

    import bpy
    folder = f"python/lib/python{sys.version_info.major}.{sys.version_info.minor}/site-packages"
    sys.path.append(f"{bpy.utils.resource_path('LOCAL')}/{folder}")
    import PyOpenColorIO
    write_configuration(Path(sys.argv[1]), {"P3": P3, "ACEScg": AP1}[sys.argv[2]], PyOpenColorIO)
