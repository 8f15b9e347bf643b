"""Layered RGB materials in the probe scenes, and what the formula says of their pixels."""

from dataclasses import dataclass

import bpy
import numpy as np

from ..blender.datablocks import groups, materials
from ..models import making
from ..models.layered_rgb import formulas as layered
from ..models.layered_rgb.parameters import LayeredRGB
from . import scenes

__all__ = ["material", "Reference", "furnace_tiles", "furnace_means", "sphere_reference", "hemisphere",
           "rings", "ring_means", "tile_normal", "TILE_ANGLES", "TILE_PIXELS"]

EAST = np.array([1.0, 0.0, 0.0])
TILE_ANGLES = np.radians([0.0, 20.0, 40.0, 60.0, 75.0, -20.0, -40.0, -60.0])
"""Of the eight tiles' normals to the view, towards and away from the deviation."""
TILE_PIXELS = 6


def material(realisation, **parameters):
    """A layered RGB material whose azimuth counts from the world's X axis, as the references have it."""
    made = materials.create(making.made("layered_rgb", realisation=realisation, **parameters))
    tree = made.node_tree
    east = tree.nodes.new("ShaderNodeCombineXYZ")
    east.inputs[0].default_value = 1.0
    tree.links.new(east.outputs[0], groups.socket_named(materials.our_node(made), "Tangent"))
    return made


@dataclass
class Reference:
    """The formula with a material's parameters."""

    parameters: object

    @classmethod
    def of(cls, **parameters):
        return cls(LayeredRGB().changed(**parameters))

    def times_cosine(self, light, normals):
        """BRDF times N.L towards the probe camera; light and normals broadcast, ``(..., 3)``."""
        view = np.broadcast_to(scenes.VIEW, normals.shape)
        brdf = layered.evaluate(self.parameters, normals, view, light, EAST)
        return brdf * np.maximum(np.sum(light * normals, axis=-1), 0.0)[..., None]

    def albedo(self, normal):
        """∫ BRDF (N.L) dω for one normal, by quadrature about the normal."""
        directions, solid_angle = hemisphere()
        side = np.cross(normal, [0.0, 1.0, 0.0])
        side /= np.linalg.norm(side)
        frame = np.stack([side, np.cross(normal, side), normal])
        light = directions @ frame
        normals = np.broadcast_to(normal, light.shape)
        return np.sum(self.times_cosine(light, normals) * solid_angle[:, None], axis=0)


def hemisphere(polar=240, azimuthal=200):
    """Directions about Z, (n, 3), and their solid angles: Gauss in the cosine, even in azimuth."""
    nodes, weights = np.polynomial.legendre.leggauss(polar)
    z, w = (nodes + 1) / 2, weights / 2
    phi = (np.arange(azimuthal) + 0.5) / azimuthal * 2 * np.pi
    z, phi = np.meshgrid(z, phi, indexing="ij")
    s = np.sqrt(1 - z * z)
    directions = np.stack([s * np.cos(phi), s * np.sin(phi), z], axis=-1).reshape(-1, 3)
    return directions, np.repeat(w, azimuthal) * 2 * np.pi / azimuthal


def tile_normal(angle):
    """Normal of a tile turned about the Y axis."""
    return np.array([np.sin(angle), 0.0, np.cos(angle)])


def furnace_tiles(realisation, parameters, *, samples, osl=False):
    """A new scene of eight tiles of a layered RGB material in a row under a white sky, at TILE_ANGLES.

    They are seen by the camera alone, so that none lights another.
    """
    count = len(TILE_ANGLES)
    scene = scenes.empty_scene(count * TILE_PIXELS, samples=samples, osl=osl, extent=count)
    scene.render.resolution_y = TILE_PIXELS
    scenes.set_world(scene, 1.0)
    scene.world.cycles.sampling_method = "NONE"
    shader = material(realisation, **parameters)
    for i, angle in enumerate(TILE_ANGLES):
        bpy.ops.mesh.primitive_plane_add(size=1.0, location=(i + 0.5 - 0.5 * count, 0.0, 0.0),
                                         rotation=(0.0, angle, 0.0))
        tile = bpy.context.object
        tile.scale = (1.0 / np.cos(angle), 1.0, 1.0)
        tile.data.materials.append(shader)
        tile.visible_diffuse = tile.visible_glossy = tile.visible_shadow = tile.visible_transmission = False
    return scene


def furnace_means(pictures):
    """Mean of each tile's inner pixels, (seeds, tiles, 3)."""
    seeds, rows = pictures.shape[:2]
    tiles = pictures.reshape(seeds, rows, len(TILE_ANGLES), TILE_PIXELS, 3)[:, 1:-1, :, 1:-1]
    return tiles.mean(axis=(1, 3))


def sphere_reference(reference, resolution, towards, diameter, *, strength=1.0, subsamples=4, disc_rings=3):
    """The sphere's pixels under a sun, (resolution, resolution, 3), and the mask of those wholly on it."""
    normals, mask = scenes.pixel_normals(resolution, subsamples=subsamples)
    picture = np.zeros((resolution, resolution, 3))
    chosen = normals[mask]
    values = np.zeros((len(chosen), 3))
    for light, irradiance in zip(*scenes.sun_directions(towards, diameter, rings=disc_rings)):
        values += irradiance * reference.times_cosine(np.broadcast_to(light, chosen.shape), chosen).mean(axis=1)
    picture[mask] = strength * values
    return picture, mask


def rings(resolution, count=6):
    """Ring number of each pixel by its distance from the sphere's middle, even in area."""
    at = (np.arange(resolution) + 0.5) / resolution * 2.0 - 1.0
    y, x = np.meshgrid(at, at, indexing="ij")
    return np.minimum(((x * x + y * y) * count).astype(int), count - 1)


def ring_means(picture, mask):
    """Means over those rings of the masked pixels, (..., rings, 3)."""
    which = rings(mask.shape[0])
    return np.stack([picture[..., mask & (which == ring), :].mean(axis=-2) for ring in range(which.max() + 1)], axis=-2)
