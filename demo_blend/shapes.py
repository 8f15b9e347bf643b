"""Solids for the sets: boxes with rounded edges, flat polygons, digits of seven segments."""

import bmesh
import bpy
import numpy as np

__all__ = ["rounded_box", "polygon", "seven_segments"]


def rounded_box(name, size, radius, material, *, segments=4):
    """A mesh object: a box of this size about its origin, its edges rounded."""
    mesh = bpy.data.meshes.new(name)
    solid = bmesh.new()
    bmesh.ops.create_cube(solid, size=1.0)
    bmesh.ops.scale(solid, vec=size, verts=solid.verts)
    bmesh.ops.bevel(solid, geom=solid.edges[:], offset=radius, segments=segments, profile=0.5, affect="EDGES")
    flat = {face.index for face in sorted(solid.faces, key=lambda f: -f.calc_area())[:6]}
    for face in solid.faces:
        face.smooth = True
    solid.to_mesh(mesh)
    solid.free()
    _keep_flat(mesh, flat)
    mesh.materials.append(material)
    return _linked(name, mesh)


def _keep_flat(mesh, flat):
    """Normals of the large faces rule at their corners, so that a rounded edge does not bend the face's shading."""
    normals = np.zeros((len(mesh.loops), 3))
    own = {vertex: polygon.normal for polygon in mesh.polygons if polygon.index in flat
           for vertex in polygon.vertices}
    for loop in mesh.loops:
        normals[loop.index] = own.get(loop.vertex_index, mesh.vertices[loop.vertex_index].normal)
    mesh.normals_split_custom_set(normals.tolist())


def polygon(name, corners, thickness, material):
    """A mesh object: a flat polygon with corners (x, y), extruded up by the thickness."""
    count = len(corners)
    vertices = [(x, y, z) for z in (0.0, thickness) for x, y in corners]
    sides = [(j, (j + 1) % count, count + (j + 1) % count, count + j) for j in range(count)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], [tuple(range(count))[::-1], tuple(range(count, 2 * count)), *sides])
    mesh.materials.append(material)
    return _linked(name, mesh)


SEGMENTS = {  # of each digit: top, upper right, lower right, bottom, lower left, upper left, middle
    "0": "abcdef", "1": "bc", "2": "abdeg", "3": "abcdg", "4": "bcfg",
    "5": "acdfg", "6": "acdefg", "7": "abc", "8": "abcdefg", "9": "abcdfg",
}


def seven_segments(digit, height, width, material, *, line=0.16, thickness=0.01, slant=0.1):
    """The lit segments of a digit as objects, its lower left corner at the origin; `line` as a share of the height."""
    t, middle = 0.5 * line * height, 0.5 * height
    gap = 0.25 * t

    def lying(y):
        return [(gap + t, y - t), (width - gap - t, y - t), (width - gap, y), (width - gap - t, y + t),
                (gap + t, y + t), (gap, y)]

    def standing(x, low, high):
        return [(x - t, low + gap + t), (x, low + gap), (x + t, low + gap + t), (x + t, high - gap - t),
                (x, high - gap), (x - t, high - gap - t)]
    corners = {"a": lying(height), "g": lying(middle), "d": lying(0.0),
               "b": standing(width, middle, height), "c": standing(width, 0.0, middle),
               "f": standing(0.0, middle, height), "e": standing(0.0, 0.0, middle)}
    return [polygon(f"Digit {digit}{name}", [(x + slant * y, y) for x, y in corners[name]], thickness, material)
            for name in SEGMENTS[digit]]


def _linked(name, mesh):
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    return made
