"""How deep the bodies of a material are: what formats without absorption over the depth take one color for."""

import bpy
import numpy as np

__all__ = ["mean_depth"]


def mean_depth(material):
    """The mean chord of the closed meshes that have a material, in scene units; None where there is none.

    4V/S of a body of volume V and surface S (Cauchy), for any shape, hollow ones among them.
    """
    chords = [_chord(found) for found in bpy.data.objects if found.type == "MESH" and any(
        getattr(slot.material, "original", slot.material) == material for slot in found.material_slots)]
    chords = [chord for chord in chords if chord]
    return float(np.mean(chords)) if chords else None


def _chord(body):
    """4V/S of an object's mesh as it lies in the scene, or None for one that is not closed."""
    mesh = body.data
    if not mesh.polygons or not _is_closed(mesh):
        return None
    mesh.calc_loop_triangles()
    corners = _read(mesh.loop_triangles, "vertices", 3, np.int32)
    points = _read(mesh.vertices, "co", 3, np.float32) @ np.array(body.matrix_world.to_3x3()).T
    a, b, c = (points[corners[:, i]] for i in range(3))
    across = np.cross(b - a, c - a)
    volume, surface = abs(np.sum(a * across)) / 6.0, 0.5 * np.sum(np.linalg.norm(across, axis=-1))
    return 4.0 * volume / surface if surface > 0.0 else None


def _is_closed(mesh):
    """Whether each edge has two faces."""
    edges = np.empty(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("edge_index", edges)
    return bool(np.all(np.bincount(edges, minlength=len(mesh.edges)) == 2))


def _read(collection, name, size, kind):
    found = np.empty((len(collection), size), kind)
    collection.foreach_get(name, found.ravel())
    return found
