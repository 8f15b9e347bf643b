"""Cook-Torrance by the nearest native closures: light-sampled on every device, and in EEVEE.

s * sum_j w_j Metallic(roughness sqrt(m_j)) + d * Diffuse is the 1982 model with
Smith's G in place of the V-cavity G, since the Beckmann closure of roughness
sqrt(m) has rms slope m and the Metallic BSDF evaluates F at V.H.  Roughness,
weight and anisotropy of each closure follow N.V so that it comes next to the
V-cavity's: see addon.models.cook_torrance.v_cavity_lobe.

Blender 4.5's conductor Fresnel is far off where k is 0.  For dielectrics there
the group F82 has the same sockets; F0 and F82 tint are worked out from n and k,
and the Metallic BSDF interpolates between them.
"""

from ...operands import clip, less, part, sqrt, where
from ...reflectance.fresnel import COS_THETA_82, conductor, f82_tint_of, tinted
from ..parameters import add_inputs
from .gaussian_lobes import gaussian_lobes, gaussian_share
from .parameters import TABLE, slope_operands
from .scale import in_scale
from .v_cavity_lobe import seen_from, v_cavity_lobe

__all__ = ["build", "build_f82"]

OF_KIND = {"PHYSICAL_CONDUCTOR": "", "F82": " by F82"}
"""What the names of parts end in for a kind of Fresnel."""


def build(builder):
    """Build the group, with n and k for a Metallic BSDF that evaluates them itself."""
    _build(builder, lambda n, k: ({"IOR": n, "Extinction": k}, "PHYSICAL_CONDUCTOR"))


def build_f82(builder):
    """Build the group for dielectrics in Blender 4.5."""
    _build(builder, lambda n, k: (dict(zip(("Base Color", "Edge Tint"), _f0_and_tint(n, k))), "F82"))


@part("F0 and F82 Tint", "F0", "Tint")
def _f0_and_tint(n, k):
    """F0 and tint of the F82 model, each within [0, 1], ``(..., 3)``."""
    f0 = conductor(1.0, n, k)
    return clip(f0, 0.0, 1.0), clip(f82_tint_of(f0, conductor(COS_THETA_82, n, k)), 0.0, 1.0)


def _build(builder, fresnel_of):
    """The group with the Fresnel inputs and type that `fresnel_of(n, k)` gives its Metallic BSDFs."""
    sockets = add_inputs(builder, TABLE, "fast")
    normal = builder.normal(sockets.normal)
    fresnel, fresnel_type = fresnel_of(*tinted(sockets.n, sockets.k, sockets.tint))
    with builder.frame("Frame"):
        # The nodes of a tangent that nothing turns on fold away.
        tangent = where(less(0.0, sockets.anisotropy), builder.tangent(sockets.tangent), (1.0, 0.0, 0.0))
    seen = seen_from(normal, builder.incoming(), tangent, sockets.rotation, sockets.anisotropy)
    surface = {**fresnel, "Normal": normal, "Tangent": seen.tangent, "Anisotropy": sockets.anisotropy,
               "Rotation": where(less(0.0, sockets.anisotropy), sockets.rotation, 0.0)}
    slope = part(f"Slope{OF_KIND[fresnel_type]}")(_slope)
    lobes = [slope(builder, m, 0.5 * sockets.specular, w, sockets.gaussian, sockets.published, sockets.gaussian_c, seen,
                   surface, fresnel_type) for m, w in slope_operands(sockets)]
    # A printed c of the Gaussian above the one that normalises is held to it, as a closure's weight is to 1.
    with builder.frame("R = s Rs + d Rd"):
        specular = in_scale(builder, builder.add_shaders(*lobes), sockets.published)
        diffuse = builder.node("ShaderNodeBsdfDiffuse", {"Color": sockets.tint * sockets.diffuse, "Normal": normal})
        total = builder.add_shaders(specular, builder.scale_shader(1.0 - sockets.specular, diffuse))
    builder.output("BSDF", total)


def _slope(builder, m, half_specular, w, gaussian, published, gaussian_c, seen, surface, fresnel_type):
    """The lobes of one rms slope m of weight w: one for Beckmann's D, three for the Gaussian.

    seen     of :func:`addon.models.cook_torrance.v_cavity_lobe.seen_from`
    surface  {socket: operand} of the Metallic BSDFs
    """
    anisotropy = surface["Anisotropy"]
    roughness, weight, leaning = v_cavity_lobe(seen.sine, m * seen.stretch, sqrt(m), seen.free, m * seen.steepest)
    surface = {**surface, "Anisotropy": anisotropy + leaning}
    share = (half_specular * w) * weight  # outside of the lobe, so that a slope without weight folds away
    share_gaussian = share * gaussian_share(m, gaussian, published, gaussian_c, anisotropy)
    lobes = [(share * (1.0 - gaussian), roughness)]
    lobes += [(share_gaussian * share_of_three, widening * roughness) for share_of_three, widening in gaussian_lobes(m)]
    lobe = part(f"Beckmann Lobe{OF_KIND[fresnel_type]}")(_beckmann)
    return builder.add_shaders(*[lobe(builder, half, rough, surface, fresnel_type) for half, rough in lobes])


def _beckmann(builder, half, roughness, surface, fresnel_type):
    """2 half F D G / (4 (N.L)(N.V)), Beckmann D of the slope roughness², Smith G; half of a share, as it may pass 1."""
    metallic = builder.node("ShaderNodeBsdfMetallic", {**surface, "Roughness": roughness},
                            distribution="BECKMANN", fresnel_type=fresnel_type)
    return builder.scale_shader_twofold(half, metallic)
