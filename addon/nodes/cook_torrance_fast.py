"""Cook-Torrance by the nearest native closures: light-sampled on every device, and in EEVEE.

s * sum_j w_j Metallic(roughness sqrt(m_j)) + d * Diffuse is the 1982 model with
Smith's G in place of the V-cavity G, since the Beckmann closure of roughness
sqrt(m) has rms slope m and the Metallic BSDF evaluates F at V.H.
"""

from ..operands import sqrt
from ..reflectance.gaussian_lobes import gaussian_lobes
from ..reflectance.slopes import gaussian_c
from .builder import GroupBuilder
from .cook_torrance_inputs import cook_torrance_inputs

__all__ = ["NAME", "VERSION", "build", "build_with", "conductor_closure"]

NAME = "Cook-Torrance Fast"
VERSION = 1


def build():
    """The node group, newly built."""
    return build_with(NAME, conductor_closure)


def conductor_closure(builder, sockets):
    """Fresnel inputs of a Metallic BSDF that evaluates n and k itself."""
    return {"IOR": sockets.n, "Extinction": sockets.k}, "PHYSICAL_CONDUCTOR"


def build_with(name, fresnel_of):
    """The group with the Fresnel inputs that `fresnel_of(builder, sockets)` gives its Metallic BSDFs."""
    builder = GroupBuilder(name)
    sockets = cook_torrance_inputs(builder)
    normal = builder.normal(sockets.normal)
    fresnel = fresnel_of(builder, sockets)
    lobes = []
    for j, (m, w) in enumerate(sockets.slopes, 1):
        with builder.frame(f"Slope {j}"):
            lobes += _slope(builder, sockets, m, sockets.specular * w, fresnel, normal)
    with builder.frame("R = s Rs + d Rd"):
        specular = _scaled(builder, builder.add_shaders(*lobes), sockets)
        diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": sockets.diffuse, "Normal": normal})
        total = builder.add_shaders(specular, builder.scale_shader(1.0 - sockets.specular, diffuse))
    builder.output("BSDF", total)
    return builder.finish()


def _slope(builder, sockets, m, share, fresnel, normal):
    """The lobes of one rms slope: one for Beckmann's D, three for the Gaussian."""
    lobes = [(share * (1.0 - sockets.gaussian), m)]
    printed = sockets.gaussian_c / gaussian_c(m)  # in the published scale the printed c takes that one's place
    gaussian = share * (sockets.gaussian * (1.0 + sockets.published * (printed - 1.0)))
    lobes += [(gaussian * part, slope) for part, slope in gaussian_lobes(m)]
    return [_beckmann(builder, part, slope, fresnel, normal) for part, slope in lobes]


def _beckmann(builder, share, m, fresnel, normal):
    """share * F D G / (4 (N.L)(N.V)), Beckmann D of rms slope m, Smith G."""
    inputs, fresnel_type = fresnel
    metallic = builder.node("ShaderNodeBsdfMetallic", {**inputs, "Roughness": sqrt(m), "Normal": normal},
                            distribution="BECKMANN", fresnel_type=fresnel_type)
    return builder.scale_shader(share, metallic)


def _scaled(builder, specular, sockets):
    """The specular part, four times as bright in the published scale.

    A closure's weight is held to 1, so four equal closures are added up; a printed
    c of the Gaussian above the one that normalises is held to it.
    """
    twice = builder.add_shaders(specular, specular)
    return builder.node("ShaderNodeMixShader", {
        "Fac": sockets.published, "Shader": specular, "Shader_001": builder.add_shaders(twice, twice)})
