"""Cook-Torrance under lamps of every kind, what the formula says of it by quadrature, and how the two are compared."""

import bpy
import numpy as np

from ..models.cook_torrance import formulas as ct
from . import scenes

__all__ = ["COPPER", "FIGURE_6B", "FURNACE_ANGLES", "furnace", "tile_means", "times_cosine", "sun_reference", "LAMPS",
           "point_lamp", "lamp_reference", "SKY_RADIANCE", "add_sky", "sky_reference", "bands", "TILE_PIXELS"]

COPPER = {"n": (0.2, 0.92, 1.1), "k": (3.91, 2.45, 2.14)}
FIGURE_6B = ((0.4, 0.4), (0.2, 0.6))
FURNACE_ANGLES = np.radians([0.0, 15.0, 30.0, 45.0, 60.0, 70.0, 75.0, 80.0])
TILE_PIXELS = 6


def furnace(make_material, samples, *, osl=False, world=1.0):
    """A scene of eight tiles turned to FURNACE_ANGLES in a row under an even sky, none lit by another."""
    count = len(FURNACE_ANGLES)
    scene = scenes.empty_scene(count * TILE_PIXELS, samples=samples, osl=osl, extent=count)
    scene.render.resolution_y = TILE_PIXELS
    scenes.set_world(scene, world)
    material = make_material()
    for i, angle in enumerate(FURNACE_ANGLES):
        bpy.ops.mesh.primitive_plane_add(location=(i + 0.5 - 0.5 * count, 0.0, 0.0), rotation=(0.0, angle, 0.0))
        tile = bpy.context.object
        tile.scale = (0.5 / np.cos(angle), 0.5, 1.0)
        tile.data.materials.append(material)
        tile.visible_diffuse = tile.visible_glossy = tile.visible_transmission = tile.visible_shadow = False
    return scene


def tile_means(pictures):
    """Mean of each tile's inner pixels, (seeds, tiles, 3)."""
    seeds = len(pictures)
    tiles = pictures.reshape(seeds, TILE_PIXELS, len(FURNACE_ANGLES), TILE_PIXELS, 3)[:, 1:-1, :, 1:-1]
    return tiles.mean(axis=(1, 3))


def times_cosine(normals, light, *, slopes=((0.2, 1.0),), n=COPPER["n"], k=COPPER["k"], specular=1.0,
                 diffuse=(0.0,) * 3, **options):
    """The formula's BRDF times N.L towards the probe camera, for directions that broadcast, ``(..., 3)``."""
    brdf = ct.cook_torrance(normals, scenes.VIEW, light, slopes=slopes, index=np.array(n), extinction=np.array(k),
                            s=specular, normal_reflectance=np.array(diffuse), **options)
    return brdf * np.maximum(np.sum(normals * light, axis=-1), 0.0)[..., None]


def sun_reference(resolution, towards, diameter, *, subsamples=3, rings=4, **parameters):
    """The sphere under a sun of irradiance 1, (rows, columns, 3), and the mask of pixels wholly on it."""
    normals, mask = scenes.pixel_normals(resolution, subsamples=subsamples)
    picture = np.zeros((resolution, resolution, 3))
    for light, irradiance in zip(*scenes.sun_directions(towards, diameter, rings=rings)):
        picture[mask] += irradiance * times_cosine(normals[mask], light, **parameters).mean(axis=1)
    return picture, mask


# --- Lamps: each sets itself up and returns points on it with normal and radiance times area ---

LAMP_PLACE = np.array([2.0, 0.6, 2.2])


def _lamp(scene, kind, **properties):
    data = bpy.data.lights.new(kind, kind)
    for name, value in properties.items():
        setattr(data, name, value)
    lamp = bpy.data.objects.new(kind, data)
    lamp.location = LAMP_PLACE
    lamp.rotation_euler = _facing().to_euler()
    scene.collection.objects.link(lamp)
    return lamp


def _facing():
    """The rotation that turns -Z from the lamp's place to the sphere."""
    from mathutils import Vector
    return Vector(-LAMP_PLACE).to_track_quat("-Z", "Y")


def _square(size, count=10):
    """Points evenly over the square lamp, and its normal."""
    at = size * ((np.arange(count) + 0.5) / count - 0.5)
    x, y = np.meshgrid(at, at)
    local = np.stack([x, y, 0.0 * x], axis=-1).reshape(-1, 3)
    rotation = np.array(_facing().to_matrix())
    return LAMP_PLACE + local @ rotation.T, rotation @ [0.0, 0.0, -1.0]


def point_lamp(scene, radius=0.4, power=100.0):
    """A ball of this radius: seen from anywhere a disc of even radiance power/(4 π² radius²)."""
    _lamp(scene, "POINT", energy=power, shadow_soft_size=radius, use_soft_falloff=False)
    radius = max(radius, 1e-3)  # for the quadrature
    return {"radius": radius, "radiance": power / (4.0 * np.pi ** 2 * radius ** 2)}


def area_lamp(scene, size=1.2, power=100.0):
    """A square that shines to one side with radiance power/(π size²)."""
    _lamp(scene, "AREA", energy=power, shape="SQUARE", size=size)
    points, normal = _square(size)
    return {"points": points, "normal": normal, "radiance_area": power / np.pi / len(points)}


def mesh_lamp(scene, size=1.2, radiance=20.0):
    """A glowing square mesh."""
    bpy.ops.mesh.primitive_plane_add(size=size, location=LAMP_PLACE, rotation=_facing().to_euler())
    plane = bpy.context.object
    material = bpy.data.materials.new("Glow")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    glow = nodes.new("ShaderNodeEmission")
    glow.inputs["Strength"].default_value = radiance
    material.node_tree.links.new(glow.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    plane.data.materials.append(material)
    plane.visible_camera = False
    points, normal = _square(size)
    return {"points": points, "normal": normal, "radiance_area": radiance * size ** 2 / len(points)}


LAMPS = {"point lamp": point_lamp, "area lamp": area_lamp, "mesh lamp": mesh_lamp}


def lamp_reference(resolution, lamp, *, subsamples=3, **parameters):
    """The sphere under one of LAMPS, and the mask."""
    normals, mask = scenes.pixel_normals(resolution, subsamples=subsamples)
    picture = np.zeros((resolution, resolution, 3))
    place = normals[mask]
    lights = _ball_lights(place, lamp) if "radius" in lamp else _square_lights(place, lamp)
    for light, strength in lights:
        picture[mask] += (times_cosine(place, light, **parameters) * strength[..., None]).mean(axis=1)
    return picture, mask


def _square_lights(place, lamp):
    for point in lamp["points"]:
        to = point - place
        distance2 = np.sum(to * to, axis=-1)
        light = to / np.sqrt(distance2)[..., None]
        facing = np.maximum(-(light @ lamp["normal"]), 0.0)
        yield light, lamp["radiance_area"] * facing / distance2


def _ball_lights(place, lamp, rings=6, spokes=16):
    to = LAMP_PLACE - place
    distance = np.linalg.norm(to, axis=-1, keepdims=True)
    axis = to / distance
    side = np.cross(axis, [0.0, 1.0, 0.0])
    side /= np.linalg.norm(side, axis=-1, keepdims=True)
    up = np.cross(axis, side)
    cos_rim = np.sqrt(1.0 - (lamp["radius"] / distance) ** 2)
    solid_angle = 2.0 * np.pi * (1.0 - cos_rim[..., 0])
    for ring in range(rings):
        cosine = 1.0 - (1.0 - cos_rim) * (ring + 0.5) / rings
        sine = np.sqrt(1.0 - cosine * cosine)
        for spoke in range(spokes):
            phi = 2.0 * np.pi * (spoke + 0.5 * (ring % 2)) / spokes
            yield (cosine * axis + sine * (np.cos(phi) * side + np.sin(phi) * up),
                   lamp["radiance"] * solid_angle / (rings * spokes))


# --- An environment picture ---

def _sky():
    """A picture of 32 x 16 pixels: dim, with a window and a patch of evening sky."""
    radiance = np.full((16, 32, 3), 0.2)
    radiance[9:13, 6:10] = (6.0, 5.5, 5.0)
    radiance[8:10, 18:28] = (2.0, 1.0, 0.6)
    return radiance


SKY_RADIANCE = _sky()


def add_sky(scene):
    """The picture as the scene's environment, its pixels with sharp edges."""
    height, width = SKY_RADIANCE.shape[:2]
    image = bpy.data.images.new("Sky", width, height, float_buffer=True)
    image.colorspace_settings.is_data = True
    image.pixels.foreach_set(
        np.concatenate([SKY_RADIANCE, np.ones((height, width, 1))], axis=2).astype(np.float32).ravel())
    image.pack()
    background = scenes.set_world(scene, 1.0)
    tree = scene.world.node_tree
    texture = tree.nodes.new("ShaderNodeTexEnvironment")
    texture.image = image
    texture.interpolation = "Closest"
    tree.links.new(texture.outputs["Color"], background.inputs["Color"])


def sky_reference(resolution, *, subsamples=2, fine=4, **parameters):
    """The sphere under the picture, by quadrature over its pixels, each cut into fine x fine, and the mask."""
    normals, mask = scenes.pixel_normals(resolution, subsamples=subsamples)
    picture = np.zeros((resolution, resolution, 3))
    height, width = SKY_RADIANCE.shape[:2]
    v = (np.arange(height * fine) + 0.5) / (height * fine)
    u = (np.arange(width * fine) + 0.5) / (width * fine)
    for row, elevation in enumerate(np.pi * (v - 0.5)):
        solid_angle = (2 * np.pi / len(u)) * (np.pi / len(v)) * np.cos(elevation)
        azimuth = -2.0 * np.pi * (u - 0.5)  # as Cycles reads an equirectangular picture
        lights = np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth),
                           np.full_like(azimuth, np.sin(elevation))], axis=-1)
        for column, light in enumerate(lights):
            radiance = SKY_RADIANCE[row // fine, column // fine] * solid_angle
            picture[mask] += times_cosine(normals[mask], light, **parameters).mean(axis=1) * radiance
    return picture, mask


def bands(picture, reference, mask, count=6):
    """Means over parts of the sphere that reflect equally much, (..., 2 count, channels).

    Left and right half each cut by brightness: mirrors hit a small lamp seldom,
    and only a part with many hits has a mean that spreads evenly.
    """
    order_by = np.where(mask, reference.sum(axis=-1), -1.0)
    columns = np.arange(reference.shape[1])[None, :]
    middle = (order_by * mask * columns).sum() / (order_by * mask).sum()
    means = []
    for half in (mask & (columns <= middle), mask & (columns > middle)):
        rows, cols = np.nonzero(half)
        order = np.argsort(order_by[rows, cols])
        reached = np.cumsum(order_by[rows, cols][order])
        part = np.minimum((reached / reached[-1] * count).astype(int), count - 1)
        means += [picture[..., rows[order[part == i]], cols[order[part == i]], :].mean(axis=-2)
                  for i in range(count) if (part == i).any()]
    return np.stack(means, axis=-2)
