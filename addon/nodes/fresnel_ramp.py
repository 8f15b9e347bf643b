"""The baked Fresnel curve as a node group: colour over the angle between view and normal.

For any shader that takes a colour.  F is looked up at N.V, where a microfacet
model has it at V.H: the same for a mirror, an approximation for rough surfaces.
"""

from ..models.parameters import Direction
from ..operands import absolute, clip, dot, vector
from .builder import GroupBuilder

__all__ = ["NAME", "VERSION", "build", "set_curve", "curve_node"]

NAME = "Fresnel Ramp"
VERSION = 1
CURVE_NODE = "Baked Fresnel"


def build():
    """The node group, newly built, with a straight line for a curve: see :func:`set_curve`."""
    builder = GroupBuilder(NAME)
    normal, = Direction(name="normal", socket="Normal",
                        tip="Shading normal; the surface's own where nothing is plugged in").sockets()
    socket = builder.input(normal)
    with builder.frame("cos θ = N·V"):
        cos_theta = clip(absolute(dot(builder.normal(socket), builder.incoming())), 0.0, 1.0)
    with builder.frame("F(θ)"):
        curve = builder.node("ShaderNodeRGBCurve", {"Color": vector(cos_theta, cos_theta, cos_theta)},
                             label=CURVE_NODE)
    builder.output("Color", curve, "COLOR", description="Reflectance at this angle")
    return builder.finish()


def curve_node(tree):
    """The RGB Curves node of a ramp group."""
    return next(node for node in tree.nodes if node.bl_idname == "ShaderNodeRGBCurve")


def set_curve(tree, cos_theta, rgb):
    """Put baked knots into a ramp group.

    cos_theta  ascending from 0 to 1, shape (knots,)
    rgb        reflectance at the knots, shape (knots, 3)
    """
    mapping = curve_node(tree).mapping
    mapping.use_clip = False
    mapping.extend = "HORIZONTAL"
    for channel in range(3):
        points = mapping.curves[channel].points
        while len(points) > 2:
            points.remove(points[1])
        while len(points) < len(cos_theta):
            points.new(0.5, 0.5)
        for point, x, row in zip(points, cos_theta, rgb):
            point.location = (x, row[channel])
            point.handle_type = "VECTOR"
    mapping.update()
