"""Where two meshes touch: the faces of one that lie on the other, and those of the other that they cover."""

from typing import NamedTuple

import numpy as np
from mathutils.bvhtree import BVHTree

__all__ = ["Wet", "remove_faces", "wet_faces"]

NEAR = 2e-3
"""Of the larger mesh's size, within which a face lies on another: meshes of other divisions are that far apart."""
OPPOSITE = -0.7
"""Most that the cosine between the normals of two faces may be which are each other's two sides."""
INWARDS = 0.1
"""Share of the way from a face's corner to its middle at which the corner is looked at, away from neighbours."""


class Wet(NamedTuple):
    """Numbers of faces: the inner mesh's that lie on the outer one, the outer's under them, and its half under them."""

    inner: list
    outer: list
    half: list


def wet_faces(inner, outer):
    """The Wet of two mesh objects, as they stand in the scene, without their modifiers."""
    of_inner, of_outer = (_polygons(target) for target in (inner, outer))
    near = NEAR * max(float(np.ptp([corner for face in faces for corner in face[0]], axis=0).max())
                      for faces in (of_inner, of_outer) if faces) if of_inner and of_outer else 0.0
    wet = [number for number, share in enumerate(_shares(of_inner, of_outer, near)) if share == 1.0]
    shares = _shares(of_outer, [of_inner[number] for number in wet], near) if wet else []
    return Wet(wet, [number for number, share in enumerate(shares) if share == 1.0],
               [number for number, share in enumerate(shares) if 0.0 < share < 1.0])


def remove_faces(mesh, numbers):
    """Take faces out of a mesh, with the edges and corners that nothing else has."""
    import bmesh
    edited = bmesh.new()
    edited.from_mesh(mesh)
    edited.faces.ensure_lookup_table()
    bmesh.ops.delete(edited, geom=[edited.faces[number] for number in numbers], context="FACES")
    edited.to_mesh(mesh)
    edited.free()
    mesh.update()


def _polygons(target):
    """[(corners in the world ``(K, 3)``, unit normal ``(3,)``)] of a mesh object's faces."""
    mesh, world = target.data, np.array(target.matrix_world)
    corners = np.array([vertex.co for vertex in mesh.vertices]).reshape(-1, 3) @ world[:3, :3].T + world[:3, 3]
    turned = np.linalg.inv(world[:3, :3])  # normals by its transpose
    found = []
    for face in mesh.polygons:
        normal = np.array(face.normal) @ turned
        found.append((corners[list(face.vertices)], normal / max(np.linalg.norm(normal), 1e-30)))
    return found


def _shares(faces, others, near):
    """Of each face the share of its places, near its corners and its middle, that lie on the others' other side."""
    corners = [tuple(corner) for face, _ in others for corner in face]
    ends = np.cumsum([0, *(len(face) for face, _ in others)])
    tree = BVHTree.FromPolygons(corners, [tuple(range(a, b)) for a, b in zip(ends, ends[1:])])
    return [np.mean([_lies_on(tree, place, normal, others, near) for place in _places(face)]) for face, normal in faces]


def _places(face):
    middle = face.mean(axis=0)
    return [middle, *(corner + INWARDS * (middle - corner) for corner in face)]


def _lies_on(tree, place, normal, others, near):
    _, _, number, _ = tree.find_nearest(tuple(place), near)
    return number is not None and float(others[number][1] @ normal) < OPPOSITE
