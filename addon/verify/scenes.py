"""Scenes that a formula can be compared with, rendered headless.

An orthographic camera looks down -Z at a unit sphere, so V = +Z in every pixel
and N is known from the pixel's place.
"""

import os
import tempfile

import bpy
import numpy as np

from ..errors import FacetFilmError

__all__ = ["require_readable", "empty_scene", "add_sphere", "add_sun", "set_world", "render", "render_seeds",
           "pixel_normals", "sun_directions", "render_on", "VIEW", "TWO_CORES"]

VIEW = np.array([0.0, 0.0, 1.0])
TWO_CORES = 2
_device = "CPU"


def render_on(device):
    """Render the scenes that follow on "CPU" or "GPU": the devices that the preferences switch on."""
    global _device
    _device = device


def empty_scene(resolution=48, *, samples=1, osl=False, pixel_centres=False, extent=2.0):
    """A new scene with the orthographic camera, in place of the open file; returns it.

    The preferences stay, and with them the devices to render on and the extension.

    pixel_centres   sample only the middle of each pixel (not for the exact
                    realisations, whose random numbers need places that differ)
    extent          width of the view in scene units; the sphere's diameter is 2
    """
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    camera = bpy.data.cameras.new("Camera")
    camera.type = "ORTHO"
    camera.ortho_scale = extent
    eye = bpy.data.objects.new("Camera", camera)
    eye.location = (0.0, 0.0, 10.0)
    scene.collection.objects.link(eye)
    scene.camera = eye
    render_settings = scene.render
    render_settings.engine = "CYCLES"
    render_settings.resolution_x = render_settings.resolution_y = resolution
    render_settings.resolution_percentage = 100
    render_settings.threads_mode = "FIXED"
    render_settings.threads = TWO_CORES
    render_settings.use_persistent_data = True
    cycles = scene.cycles
    cycles.device = _device
    cycles.samples = samples
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 0.01 if pixel_centres else 1.0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.caustics_reflective = True
    cycles.shading_system = osl
    cycles.max_bounces = 4
    set_world(scene, 0.0)
    return scene


def add_sphere(material, segments=256):
    """A smooth unit sphere of this material at the origin; Blender's own operator takes seconds for it."""
    rings = segments // 2
    polar, azimuth = np.pi * np.arange(1, rings) / rings, 2.0 * np.pi * np.arange(segments) / segments
    sine = np.sin(polar)[:, None]
    between = np.stack([sine * np.cos(azimuth), sine * np.sin(azimuth),
                        np.broadcast_to(np.cos(polar)[:, None], (rings - 1, segments))], axis=-1)
    vertices = np.concatenate([[[0.0, 0.0, 1.0]], between.reshape(-1, 3), [[0.0, 0.0, -1.0]]])
    at = 1 + np.arange((rings - 1) * segments).reshape(rings - 1, segments)
    after = np.roll(at, -1, axis=1)
    quads = np.stack([at[:-1], at[1:], after[1:], after[:-1]], axis=-1).reshape(-1, 4)
    north = np.stack([np.zeros(segments, int), at[0], after[0]], axis=-1)
    south = np.stack([np.full(segments, len(vertices) - 1), after[-1], at[-1]], axis=-1)
    mesh = bpy.data.meshes.new("Sphere")
    mesh.from_pydata(vertices.tolist(), [], [*north.tolist(), *quads.tolist(), *south.tolist()])
    mesh.polygons.foreach_set("use_smooth", np.ones(len(mesh.polygons), bool))
    mesh.materials.append(material)
    sphere = bpy.data.objects.new("Sphere", mesh)
    bpy.context.scene.collection.objects.link(sphere)
    return sphere


def add_sun(scene, polar_angle, *, strength=1.0, diameter=0.0):
    """A sun whose direction makes polar_angle (radians) with the view; returns the unit vector L towards it."""
    light = bpy.data.lights.new("Sun", "SUN")
    light.energy = strength
    light.angle = diameter
    sun = bpy.data.objects.new("Sun", light)
    sun.rotation_euler = (0.0, polar_angle, 0.0)  # a sun shines along its local -Z
    scene.collection.objects.link(sun)
    return np.array([np.sin(polar_angle), 0.0, np.cos(polar_angle)])


def set_world(scene, grey):
    """An even world of this radiance."""
    world = scene.world or bpy.data.worlds.new("World")
    scene.world = world
    if world.node_tree is None:
        world.use_nodes = True
    background = next((n for n in world.node_tree.nodes if n.bl_idname == "ShaderNodeBackground"), None)
    if background is None:
        background = world.node_tree.nodes.new("ShaderNodeBackground")
        output = world.node_tree.nodes.new("ShaderNodeOutputWorld")
        world.node_tree.links.new(background.outputs[0], output.inputs[0])
    background.inputs["Color"].default_value = (grey, grey, grey, 1.0)
    background.inputs["Strength"].default_value = 1.0
    return background


def render(scene, seed=0):
    """The picture as float64, shape (rows from the bottom, columns, 3), in scene-linear units."""
    scene.cycles.seed = seed
    settings = scene.render.image_settings
    settings.file_format = "OPEN_EXR"
    settings.color_depth = "32"
    settings.color_mode = "RGB"
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = os.path.join(folder, "probe.exr")
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(scene.render.filepath)
        image.colorspace_settings.is_data = True
        width, height = image.size
        pixels = np.empty(width * height * image.channels, np.float32)
        image.pixels.foreach_get(pixels)
        channels = image.channels
        bpy.data.images.remove(image)
    return pixels.reshape(height, width, channels)[..., :3].astype(float)


TOLD = (0.25, 0.5, 0.75)
"""Radiance that a scene of nothing but it has to come back as."""


def require_readable():
    """Raise FacetFilmError where pixels do not come back from a file as they were rendered: nothing can be compared."""
    scene = empty_scene(2)
    background = set_world(scene, 1.0)
    background.inputs["Color"].default_value = (*TOLD, 1.0)
    if not np.allclose(render(scene), TOLD, atol=1e-4):
        raise FacetFilmError("Under this OpenColorIO configuration pixels do not come back from an OpenEXR file as "
                             "they were rendered, so nothing can be verified: use one that has a role for data, or "
                             "start Blender without it.")


def render_seeds(scene, count, first=1):
    """`count` pictures of independent seeds, shape (count, rows, columns, 3)."""
    return np.stack([render(scene, first + i) for i in range(count)])


def pixel_normals(resolution, *, extent=2.0, subsamples=1):
    """Sphere normals seen by the pixels, (rows, columns, subsamples², 3), and the mask of pixels wholly inside.

    Rows run from the bottom, as pictures do.
    """
    step = extent / resolution
    inside = (np.arange(subsamples) + 0.5) / subsamples
    at = (-0.5 * extent + step * (np.arange(resolution)[:, None] + inside)).ravel()
    y, x = np.meshgrid(at, at, indexing="ij")
    z2 = 1.0 - x * x - y * y
    normals = np.stack([x, y, np.sqrt(np.maximum(z2, 0.0))], axis=-1)
    shape = (resolution, subsamples, resolution, subsamples)
    normals = normals.reshape(*shape, 3).swapaxes(1, 2).reshape(resolution, resolution, -1, 3)
    corner = (np.abs(np.linspace(-0.5 * extent, 0.5 * extent, resolution + 1)))
    far = np.maximum(corner[1:], corner[:-1])
    mask = far[:, None] ** 2 + far[None, :] ** 2 < 0.995
    return normals, mask


def sun_directions(towards, diameter, rings=12):
    """Directions spread over a sun's disc, (rings * 48, 3), and the irradiance that each brings, (rings * 48,).

    For a sun of strength 1: Cycles gives its cone the even radiance 1/(π sin²(δ/2)),
    so the irradiances add up to 1 when each is seen under its angle to the axis.
    """
    if diameter == 0.0:
        return towards[None, :], np.ones(1)
    sine = np.sin(0.5 * diameter)
    # Even in projected solid angle about the axis: dω = dA / cos θ, so each direction's share is 1 / cos θ.
    radii = np.concatenate([np.full(48, np.sqrt((r + 0.5) / rings)) for r in range(rings)])
    angles = np.concatenate([2 * np.pi * (np.arange(48) + 0.5 * (r % 2)) / 48 for r in range(rings)])
    side = np.array([towards[2], 0.0, -towards[0]])
    up = np.cross(towards, side)
    rho = sine * radii
    cosine = np.sqrt(1.0 - rho * rho)
    directions = (rho * np.cos(angles))[:, None] * side + (rho * np.sin(angles))[:, None] * up \
        + cosine[:, None] * towards
    return directions, 1.0 / (cosine * len(cosine))
