"""A room to photograph in: an oak table, a plastered wall, a board of slate, Blender's own skies for mirrors."""

from pathlib import Path

import bpy
from mathutils import Vector

from addon.blender.compat import enable_nodes

from .shapes import rounded_box
from .studio import new_scene

__all__ = ["LEAST_SAMPLES", "add_board", "add_table", "add_wall", "focus", "set_room", "show_scene"]

WIDTH, HEIGHT = 1600, 1067
LEAST_SAMPLES = 12
"""Of a pixel, before Cycles may call it done: a wall is soon."""


def show_scene(job, samples, *, size=(WIDTH, HEIGHT), look="Khronos PBR Neutral", noise=0.03, **more):
    """A scene for a large picture, with highlights that roll off."""
    scene = new_scene(job.size(*size), job.samples(samples), look=look, denoise=True, noise=noise, **more)
    scene.cycles.adaptive_min_samples = LEAST_SAMPLES
    return scene


def focus(camera, point, stop):
    """What is as far as this point is sharp."""
    camera.data.dof.use_dof = True
    camera.data.dof.focus_distance = (camera.location - Vector(point)).length
    camera.data.dof.aperture_fstop = stop


def set_room(scene, name, *, strength, turn):
    """One of the skies that come with Blender as the room around, seen in mirrors and not by the camera.

    name  of the file among Blender's studio lights, such as "interior.exr"
    turn  about the vertical, in radians
    """
    world = bpy.data.worlds.new("Room")
    scene.world = world
    enable_nodes(world)
    tree = world.node_tree
    tree.nodes.clear()
    place, turned = tree.nodes.new("ShaderNodeTexCoord"), tree.nodes.new("ShaderNodeMapping")
    sky, background = tree.nodes.new("ShaderNodeTexEnvironment"), tree.nodes.new("ShaderNodeBackground")
    output = tree.nodes.new("ShaderNodeOutputWorld")
    folder = Path(bpy.utils.resource_path("LOCAL")) / "datafiles" / "studiolights" / "world"
    sky.image = bpy.data.images.load(str(folder / name), check_existing=True)
    sky.image.pack()
    turned.inputs["Rotation"].default_value = (0.0, 0.0, turn)
    background.inputs["Strength"].default_value = strength
    tree.links.new(place.outputs["Generated"], turned.inputs["Vector"])
    tree.links.new(turned.outputs["Vector"], sky.inputs["Vector"])
    tree.links.new(sky.outputs["Color"], background.inputs["Color"])
    tree.links.new(background.outputs[0], output.inputs["Surface"])
    for number, node in enumerate((place, turned, sky, background, output)):
        node.location = (260.0 * number, 0.0)


def add_table(size=(9.0, 5.0), planks=5):
    """Oiled oak: planks along X, each with a grain of its own, their upper side at z = 0."""
    oak, width = _oak(), size[1] / planks
    for number in range(planks):
        plank = rounded_box("Plank", (size[0], width - 0.012, 0.14), 0.012, oak)
        plank.location = (0.0, -1.9 + width * (number + 0.5) - 0.3, -0.07)
        plank.color = (number / planks, 0.0, 0.0, 1.0)


def add_wall(y=2.9):
    """Dark limewash behind the table."""
    wall = rounded_box("Wall", (16.0, 0.2, 10.0), 0.01, _limewash())
    wall.location = (0.0, y, 2.0)


def add_board(place, size=(2.5, 1.9)):
    """A board of slate."""
    board = rounded_box("Board", (*size, 0.09), 0.02, _slate())
    board.location = (place[0], place[1], place[2] + 0.045)


class _Shader:
    """A Principled BSDF of a new material, and the nodes that vary it."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        enable_nodes(self.material)
        self.tree = self.material.node_tree
        self.tree.nodes.clear()
        self.principled = self.node("ShaderNodeBsdfPrincipled")
        self.tree.links.new(self.principled.outputs[0], self.node("ShaderNodeOutputMaterial").inputs["Surface"])
        self.place = self.node("ShaderNodeTexCoord").outputs["Object"]

    def node(self, kind, links=(), **values):
        """A node with values and (socket, output) links set; in a row with the others."""
        made = self.tree.nodes.new(kind)
        made.location = (-220.0 * len(self.tree.nodes), 0.0)
        for name, value in values.items():
            setattr(made, name, value)
        for socket, output in links:
            self.set(made.inputs[socket], output)
        return made

    def set(self, socket, given):
        """Link an output, or set a value."""
        if isinstance(given, bpy.types.NodeSocket):
            self.tree.links.new(given, socket)
        else:
            socket.default_value = given

    def stretched(self, scale):
        """Object coordinates, scaled along each axis."""
        return self.node("ShaderNodeMapping", [("Vector", self.place), ("Scale", scale)]).outputs["Vector"]

    def noise(self, place, scale, detail=6.0, roughness=0.55, distortion=0.0):
        """Perlin noise, 0 to 1."""
        return self.node("ShaderNodeTexNoise", [
            ("Vector", place), ("Scale", scale), ("Detail", detail), ("Roughness", roughness),
            ("Distortion", distortion)]).outputs[0]

    def ramp(self, value, *stops):
        """Colours at positions."""
        made = self.node("ShaderNodeValToRGB", [(0, value)])
        elements = made.color_ramp.elements
        while len(elements) < len(stops):
            elements.new(0.5)
        for element, (position, colour) in zip(elements, stops):
            element.position, element.color = position, (*colour, 1.0)
        return made.outputs["Color"]

    def bump(self, height, strength, distance):
        """A bumped normal."""
        return self.node("ShaderNodeBump", [("Height", height), ("Strength", strength),
                                            ("Distance", distance)]).outputs["Normal"]


def _oak():
    shader = _Shader("Oak")
    own = shader.node("ShaderNodeObjectInfo").outputs["Random"]
    place = shader.node("ShaderNodeVectorMath", [(0, shader.stretched((0.35, 5.0, 5.0))), (1, own)], operation="ADD")
    grain = shader.noise(place.outputs[0], 2.2, 8.0, 0.6, 1.2)
    fibre = shader.noise(shader.stretched((1.5, 60.0, 60.0)), 1.5, 4.0)
    colour = shader.ramp(grain, (0.32, (0.085, 0.042, 0.020)), (0.52, (0.19, 0.100, 0.048)),
                         (0.70, (0.29, 0.170, 0.088)))
    shader.set(shader.principled.inputs["Base Color"], colour)
    shader.set(shader.principled.inputs["Roughness"], 0.42)
    shader.set(shader.principled.inputs["Normal"], shader.bump(fibre, 0.25, 0.01))
    return shader.material


def _limewash():
    shader = _Shader("Limewash")
    cloud = shader.noise(shader.place, 0.9, 8.0, 0.65)
    shader.set(shader.principled.inputs["Base Color"], shader.ramp(
        cloud, (0.3, (0.060, 0.082, 0.086)), (0.7, (0.100, 0.128, 0.130))))
    shader.set(shader.principled.inputs["Roughness"], 0.85)
    shader.set(shader.principled.inputs["Normal"], shader.bump(shader.noise(shader.place, 14.0), 0.25, 0.02))
    return shader.material


def _slate():
    shader = _Shader("Slate")
    rough = shader.noise(shader.place, 5.0, 10.0, 0.6)
    shader.set(shader.principled.inputs["Base Color"], shader.ramp(
        rough, (0.3, (0.018, 0.019, 0.021)), (0.7, (0.045, 0.046, 0.048))))
    shader.set(shader.principled.inputs["Roughness"], 0.5)
    shader.set(shader.principled.inputs["Normal"], shader.bump(rough, 0.35, 0.012))
    return shader.material
