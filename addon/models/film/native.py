"""The renderer's own film in the place of the tilted lobes: the Metallic BSDF, set by the rows of the track.

See addon.bake.film_track.  Where the image has no track, or the Blender no
native film, the share of it is 0 and Cycles folds all of this away.
"""

from types import SimpleNamespace

from ...operands import less, maximum, minimum, part, vector, widen, x_of, y_of, z_of
from ...reflectance.film_facets import native_share

__all__ = ["TRACK_ROWS", "native_film", "place_of_track"]

TRACK_ROWS = 3
"""Of the image above the table's, where there is a track: the film's index, its thickness and the slope from which it
is closer; n; k."""
LEAST_TINT = 1e-5
"""Of what is left for the tilted lobes; below it they are left out."""


@part("Place of the Track")
def place_of_track(builder, across, rows, height):
    """Where the image holds the track at a thickness, by name.

    across  of the thickness, [0, 1]
    first   of its first row up the image, [0, 1]
    row     of one row
    has     1 where the image has one: above the table there is room for it, and not for what is absorbed
    """
    has = less(rows, height) * less(height, rows + (TRACK_ROWS + 1.0))
    return SimpleNamespace(across=across, first=(rows + 0.5) / height, row=1.0 / height, has=builder.where_native(has))


@part("Native Film", "BSDF", "Tint Left", "Some Left")
def native_film(builder, n, m, roughness, tint, stretching, track):
    """(its closure, the tint that it leaves to the tilted lobes, 1 where that is any) at a slope m.

    A native film cannot be dyed: it is dimmed to the least of the tint's channels.
    """
    settings, refraction, extinction = (_row(builder, track, row) for row in (0.0, 1.0, 2.0))
    share = track.has * native_share(m, z_of(settings))
    reflects = share * minimum(minimum(x_of(tint), y_of(tint)), z_of(tint))
    metal = builder.node("ShaderNodeBsdfMetallic", {
        "IOR": refraction, "Extinction": extinction, "Normal": n, "Roughness": roughness,
        "Anisotropy": stretching.anisotropy, "Rotation": stretching.rotation, "Tangent": stretching.tangent},
        distribution="BECKMANN", fresnel_type="PHYSICAL_CONDUCTOR")
    builder.feed_where_native(metal, {"Thin Film IOR": x_of(settings), "Thin Film Thickness": y_of(settings)})
    left = tint - widen(reflects)
    some = less(LEAST_TINT, maximum(maximum(x_of(left), y_of(left)), z_of(left)))
    return builder.scale_shader(reflects, metal), left, some


def _row(builder, track, row):
    """What a row of the track holds at the thickness, ``(3,)``."""
    at = vector(track.across, track.first + row * track.row, 0.0)
    return builder.node("ShaderNodeTexImage", {"Vector": at}, "Color", interpolation="Linear", extension="EXTEND")
