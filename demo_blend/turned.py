"""Turned surfaces: a profile swept about the vertical axis."""

import bpy
import numpy as np

__all__ = ["VASE_PROFILE", "JAR_PROFILE", "bent_rod", "turned_object"]

# (radius, height) of the outer wall from foot to lip, then the inner wall back down.
VASE_PROFILE = (
    (0.00, 0.00), (0.46, 0.00), (0.50, 0.02), (0.50, 0.06), (0.45, 0.10), (0.36, 0.15), (0.31, 0.23), (0.34, 0.33),
    (0.50, 0.50), (0.73, 0.77), (0.87, 1.08), (0.88, 1.40), (0.75, 1.70), (0.53, 1.95), (0.36, 2.15),
    (0.29, 2.34), (0.29, 2.50), (0.35, 2.64), (0.44, 2.73), (0.47, 2.76), (0.45, 2.78), (0.41, 2.76), (0.31, 2.64),
    (0.25, 2.50), (0.25, 2.34), (0.31, 2.15), (0.48, 1.94), (0.70, 1.68), (0.83, 1.38), (0.82, 1.08),
    (0.68, 0.80), (0.45, 0.50), (0.00, 0.36),
)
"""An urn like the 1982 paper's: foot, belly, narrow neck and lip."""

JAR_PROFILE = (
    (0.00, 0.00), (0.56, 0.00), (0.62, 0.02), (0.66, 0.08), (0.84, 0.34), (1.00, 0.68), (1.06, 1.02), (1.00, 1.36),
    (0.82, 1.64), (0.60, 1.82), (0.46, 1.92), (0.42, 2.00), (0.44, 2.08), (0.52, 2.15), (0.55, 2.18), (0.52, 2.20),
    (0.46, 2.17), (0.39, 2.08), (0.37, 2.00), (0.41, 1.90), (0.56, 1.78), (0.78, 1.60), (0.95, 1.34), (1.01, 1.02),
    (0.95, 0.70), (0.80, 0.40), (0.00, 0.20),
)
"""A round jar with a short neck: much belly to look at a layer on."""


def turned_object(name, profile, material, *, segments=192, points_between=6):
    """A smooth mesh object: the profile's points joined by Catmull-Rom curves and turned about Z."""
    outline = _smooth(np.asarray(profile, float), points_between)
    angles = 2.0 * np.pi * np.arange(segments) / segments
    radius, height = outline[:, 0][:, None], outline[:, 1][:, None]
    vertices = np.stack([radius * np.cos(angles), radius * np.sin(angles),
                         np.broadcast_to(height, (len(outline), segments))], axis=-1).reshape(-1, 3)
    ring, step = np.meshgrid(np.arange(len(outline) - 1), np.arange(segments), indexing="ij")
    following = (step + 1) % segments
    faces = np.stack([ring * segments + step, ring * segments + following,
                      (ring + 1) * segments + following, (ring + 1) * segments + step], axis=-1).reshape(-1, 4)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices.tolist(), [], faces.tolist())
    mesh.validate()
    mesh.polygons.foreach_set("use_smooth", np.ones(len(mesh.polygons), bool))
    mesh.materials.append(material)
    turned = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(turned)
    return turned


def bent_rod(name, points, radius, material):
    """A round rod along a smooth curve through the points, its ends closed."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions, curve.bevel_depth, curve.bevel_resolution = "3D", radius, 8
    curve.use_fill_caps = True
    curve.resolution_u = 8
    line = curve.splines.new("BEZIER")
    line.bezier_points.add(len(points) - 1)
    for bezier, point in zip(line.bezier_points, points):
        bezier.co = point
        bezier.handle_left_type = bezier.handle_right_type = "AUTO"
    curve.materials.append(material)
    rod = bpy.data.objects.new(name, curve)
    bpy.context.scene.collection.objects.link(rod)
    return rod


def _smooth(points, count):
    """Catmull-Rom curve through the points, `count` pieces between two of them."""
    padded = np.concatenate([points[:1], points, points[-1:]])
    t = (np.arange(count) / count)[:, None]
    pieces = [0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3)
              for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:])]
    curve = np.concatenate([*pieces, points[-1:]])
    curve[:, 0] = np.maximum(curve[:, 0], 0.0)
    return curve
