"""Cook-Torrance by the nearest native closures: light-sampled on every device, and in EEVEE.

s * sum_j w_j Metallic(roughness sqrt(m_j)) + d * Diffuse is the 1982 model with
Smith's G in place of the V-cavity G, since the Beckmann closure of roughness
sqrt(m) has rms slope m and the Metallic BSDF evaluates F at V.H.  Roughness and
weight of each closure follow N.V so that it comes next to the V-cavity's:
see addon.models.cook_torrance.v_cavity_lobe.

Blender 4.5's conductor Fresnel is far off where k is 0.  For dielectrics there
the group F82 has the same sockets; F0 and F82 tint are worked out from n and k,
and the Metallic BSDF interpolates between them.
"""

from ...operands import clip, less, sqrt, where
from ...reflectance.fresnel import COS_THETA_82, conductor, f82_tint_of, tinted
from ...reflectance.slopes import along_across, elliptic_gaussian_c
from ..parameters import add_inputs
from .gaussian_lobes import gaussian_lobes
from .parameters import TABLE, slope_operands
from .v_cavity_lobe import SeenFrom, v_cavity_lobe

__all__ = ["build", "build_f82"]


def build(builder):
    """Build the group, with n and k for a Metallic BSDF that evaluates them itself."""
    _build(builder, lambda n, k: ({"IOR": n, "Extinction": k}, "PHYSICAL_CONDUCTOR"))


def build_f82(builder):
    """Build the group for dielectrics in Blender 4.5."""
    def fresnel_of(n, k):
        with builder.frame("F0 and F82 tint of n and k"):
            f0 = conductor(1.0, n, k)
            tint = f82_tint_of(f0, conductor(COS_THETA_82, n, k))
            return {"Base Color": clip(f0, 0.0, 1.0), "Edge Tint": clip(tint, 0.0, 1.0)}, "F82"
    _build(builder, fresnel_of)


def _build(builder, fresnel_of):
    """The group with the Fresnel inputs and type that `fresnel_of(n, k)` gives its Metallic BSDFs."""
    sockets = add_inputs(builder, TABLE, "fast")
    normal = builder.normal(sockets.normal)
    fresnel, fresnel_type = fresnel_of(*tinted(sockets.n, sockets.k, sockets.tint))
    with builder.frame("Frame"):
        # The nodes of a tangent that nothing turns on fold away.
        tangent = where(less(0.0, sockets.anisotropy), builder.tangent(sockets.tangent), (1.0, 0.0, 0.0))
    shared = {**fresnel, "Normal": normal, "Tangent": tangent, "Anisotropy": sockets.anisotropy,
              "Rotation": sockets.rotation}
    view = SeenFrom(normal, builder.incoming(), tangent, sockets.rotation, sockets.anisotropy)
    lobes = []
    for j, (m, w) in enumerate(slope_operands(sockets), 1):
        with builder.frame(f"Slope {j}"):
            lobes += _slope(builder, sockets, m, sockets.specular * w, view, shared, fresnel_type)
    with builder.frame("R = s Rs + d Rd"):
        specular = _scaled(builder, builder.add_shaders(*lobes), sockets)
        diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": sockets.tint * sockets.diffuse, "Normal": normal})
        total = builder.add_shaders(specular, builder.scale_shader(1.0 - sockets.specular, diffuse))
    builder.output("BSDF", total)


def _slope(builder, sockets, m, share, view, shared, fresnel_type):
    """The lobes of one rms slope: one for Beckmann's D, three for the Gaussian."""
    widening, weight = v_cavity_lobe(view.sine, view.slope(m))
    lobes = [(share * (1.0 - sockets.gaussian), m)]
    c = elliptic_gaussian_c(*along_across(m, sockets.anisotropy))
    printed = sockets.gaussian_c / c  # in the published scale the printed c takes that one's place
    gaussian = share * (sockets.gaussian * (1.0 + sockets.published * (printed - 1.0)))
    lobes += [(gaussian * part, slope) for part, slope in gaussian_lobes(m)]
    return [_beckmann(builder, part * weight, sqrt(slope) * widening, shared, fresnel_type) for part, slope in lobes]


def _beckmann(builder, share, roughness, shared, fresnel_type):
    """share * F D G / (4 (N.L)(N.V)), Beckmann D of this roughness, Smith G."""
    metallic = builder.node("ShaderNodeBsdfMetallic", {**shared, "Roughness": roughness},
                            distribution="BECKMANN", fresnel_type=fresnel_type)
    return builder.scale_shader_twofold(share, metallic)


def _scaled(builder, specular, sockets):
    """The specular part, four times as bright in the published scale.

    A closure's weight is held to 1, so four equal closures are added up; a printed
    c of the Gaussian above the one that normalises is held to it.
    """
    twice = builder.add_shaders(specular, specular)
    return builder.node("ShaderNodeMixShader", {
        "Fac": sockets.published, "Shader": specular, "Shader_001": builder.add_shaders(twice, twice)})
