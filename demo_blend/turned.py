"""Turned surfaces: a profile swept about the vertical axis."""

import bpy
import numpy as np

__all__ = ["VASE_PROFILE", "turned_object"]

# (radius, height) of the outer wall from foot to lip, then the inner wall back down.
VASE_PROFILE = (
    (0.00, 0.00), (0.50, 0.00), (0.53, 0.03), (0.50, 0.08), (0.38, 0.14), (0.30, 0.22), (0.33, 0.32),
    (0.52, 0.50), (0.76, 0.78), (0.88, 1.10), (0.86, 1.42), (0.70, 1.72), (0.46, 1.96), (0.32, 2.14),
    (0.27, 2.32), (0.29, 2.50), (0.40, 2.66), (0.55, 2.76), (0.57, 2.79), (0.54, 2.80), (0.36, 2.68),
    (0.24, 2.50), (0.22, 2.32), (0.27, 2.14), (0.41, 1.94), (0.64, 1.70), (0.80, 1.40), (0.82, 1.10),
    (0.70, 0.80), (0.45, 0.50), (0.00, 0.36),
)


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


def _smooth(points, count):
    """Catmull-Rom curve through the points, `count` pieces between two of them."""
    padded = np.concatenate([points[:1], points, points[-1:]])
    t = (np.arange(count) / count)[:, None]
    pieces = [0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3)
              for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:])]
    curve = np.concatenate([*pieces, points[-1:]])
    curve[:, 0] = np.maximum(curve[:, 0], 0.0)
    return curve
