"""The faces of a clear body as closures, shared by its groups."""

from types import SimpleNamespace

from ...operands import absolute, dot, less, maximum, minimum, part, where, widen
from ...reflectance.transmission import cos_inside, slab_reflectance, slab_transmittance, straight_path, transmittance
from .formulas import reflectance, relative_index, sigma_of

__all__ = ["FROSTED", "absorbed", "began_inside", "given", "sheet", "with_straight_shadows"]

FROSTED = 1e-3
"""Roughness above which a face scatters; below, a ray leaves as a mirror or a lens sends it."""


def given(builder, sockets):
    """What every group works out first, by name: n, sigma, back, length, cos_theta, normal."""
    with builder.frame("Place and path"):
        back = builder.node("ShaderNodeNewGeometry", output="Backfacing")
        length = builder.node("ShaderNodeLightPath", output="Ray Length")
        cos_theta = absolute(dot(builder.node("ShaderNodeNewGeometry", output="Normal"), builder.incoming()))
    return SimpleNamespace(
        n=relative_index(sockets.ior, sockets.outside), back=back, length=length, cos_theta=cos_theta,
        normal=builder.normal(sockets.normal),
        sigma=sigma_of(sockets.absorption, sockets.depth_colour, sockets.depth, sockets.concentration,
                       sockets.scene_scale))


def absorbed(at):
    """What is left of the light that came through the body to its back face; all of it at the front face."""
    return transmittance(at.sigma, widen(at.back * at.length))


@part("Thin Wall")
def sheet(builder, sockets, at):
    """The closure of a thin wall: both faces and the passages between them as one."""
    thickness = sockets.thickness / sockets.scene_scale
    n = maximum(at.n, 1.0 / at.n)
    r = widen(reflectance(at.cos_theta, n, 0.0))
    t = transmittance(at.sigma, widen(thickness / cos_inside(at.cos_theta, n)))
    with builder.frame("Thin wall"):
        through = builder.node("ShaderNodeBsdfTransparent", {"Color": slab_transmittance(r, t) * sockets.tint})
        mirror = builder.node("ShaderNodeBsdfAnisotropic", {
            "Color": slab_reflectance(r, t), "Roughness": sockets.roughness, "Normal": at.normal},
            distribution="BECKMANN")
        return builder.add_shaders(through, mirror)


@part("See-through Shadows")
def with_straight_shadows(builder, sockets, at, closure):
    """The closure, but for shadow and diffuse rays: what passes goes straight on, dimmed by surface and body.

    What the surface reflects of diffuse rays stays: under a ball much of the sky arrives so.  A frosted body stops the
    shadow rays that begin in it: what it scatters inwards finds its lamps by the faces that it leaves through, and so
    has none twice.
    """
    straight = straight_path(at.sigma, widen(_along(builder, at)), widen(at.back))
    with builder.frame("See-through shadows"):
        shadow = builder.node("ShaderNodeLightPath", output="Is Shadow Ray")
        diffuse = builder.node("ShaderNodeLightPath", output="Is Diffuse Ray")
        r = widen(reflectance(at.cos_theta, maximum(at.n, 1.0 / at.n), 0.0))
        through = builder.node("ShaderNodeBsdfTransparent", {"Color": straight * (1.0 - r) * sockets.tint})
        mirror = builder.node("ShaderNodeBsdfAnisotropic", {
            "Color": r * where(at.back, straight, (1.0, 1.0, 1.0)), "Roughness": sockets.roughness,
            "Normal": at.normal}, distribution="BECKMANN")
        shadow = shadow * (1.0 - less(FROSTED, sockets.roughness) * began_inside(builder, at.back))
        return mixed(builder, sockets.see_through * maximum(shadow, diffuse), closure,
                     builder.add_shaders(through, mirror))


def _along(builder, at):
    """How far along a straight ray the face is, from where both faces of the body count.

    That is the ray's start where it started inside: then its first face is a back face.  Else it is the point beside
    the object's origin, or the start where that lies behind: a face between body and floor, or before what is embedded,
    is missed by the light that ends there, which so has half a body's absorption, and never the inverse of it.
    """
    with builder.frame("Place on a straight ray"):
        beyond = dot(builder.node("ShaderNodeNewGeometry", output="Position")
                     - builder.node("ShaderNodeObjectInfo", output="Location"), -1.0 * builder.incoming())
        return where(began_inside(builder, at.back), at.length, minimum(beyond, at.length))


def began_inside(builder, back):
    """1.0 at the first face of a straight ray that started in the body: it is a back face, for which back is 1."""
    passed = builder.node("ShaderNodeLightPath", output="Transparent Depth")
    return back * less(passed, 0.5)


def mixed(builder, share, closure, other):
    """(1 − share) of a closure and share of another."""
    return builder.node("ShaderNodeMixShader", {"Fac": share, "Shader": closure, "Shader_001": other})
