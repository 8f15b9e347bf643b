"""Cook-Torrance by the nearest native closures: light-sampled on every device, and in EEVEE.

s * sum_j w_j Metallic(roughness sqrt(m_j)) + d * Diffuse is the 1982 model with
Smith's G in place of the V-cavity G, since the Beckmann closure of roughness
sqrt(m) has rms slope m and the Metallic BSDF evaluates F at V.H.
"""

from ..operands import sqrt, term
from ..reflectance.gaussian_lobes import gaussian_lobes
from .builder import GroupBuilder
from .cook_torrance_inputs import cook_torrance_inputs

__all__ = ["NAME", "VERSION", "build"]

NAME = "Cook-Torrance Fast"
VERSION = 1


def build():
    """The node group, newly built."""
    builder = GroupBuilder(NAME)
    sockets = cook_torrance_inputs(builder)
    normal = builder.normal(sockets.normal)
    lobes = []
    for j, (m, w) in enumerate(sockets.slopes, 1):
        with builder.frame(f"Slope {j}"):
            lobes += _slope(builder, sockets, m, sockets.specular * w, normal)
    with builder.frame("R = s Rs + d Rd"):
        specular = _scaled(builder, builder.add_shaders(*lobes), sockets)
        diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": sockets.diffuse, "Normal": normal})
        total = builder.add_shaders(specular, builder.scale_shader(1.0 - sockets.specular, diffuse))
    builder.output("BSDF", total)
    return builder.finish()


def _slope(builder, sockets, m, share, normal):
    """The lobes of one rms slope: one for Beckmann's D, three for the Gaussian."""
    lobes = [(share * (1.0 - sockets.gaussian), m)]
    lobes += [(share * (sockets.gaussian * part), slope) for part, slope in gaussian_lobes(m)]
    return [_beckmann(builder, part, slope, sockets, normal) for part, slope in lobes]


def _beckmann(builder, share, m, sockets, normal):
    """share * F D G / (4 (N.L)(N.V)), Beckmann D of rms slope m, Smith G."""
    metallic = builder.node("ShaderNodeBsdfMetallic", {
        "IOR": sockets.n, "Extinction": sockets.k, "Roughness": sqrt(m), "Normal": normal,
    }, distribution="BECKMANN", fresnel_type="PHYSICAL_CONDUCTOR")
    return builder.scale_shader(share, metallic)


def _scaled(builder, specular, sockets):
    """The specular part, four times as bright in the published scale.

    A closure's weight is held to 1, so four equal closures are added up.
    """
    twice = builder.add_shaders(specular, specular)
    return builder.node("ShaderNodeMixShader", {
        "Fac": sockets.published, "Shader": specular, "Shader_001": builder.add_shaders(twice, twice)})
