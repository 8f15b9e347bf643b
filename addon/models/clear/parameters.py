"""The table of a clear material's parameters."""

from ..parameters import Choice, Colour, Direction, Number, Triple, checked_class

__all__ = ["Clear", "TABLE"]

TABLE = (
    Number(name="roughness", symbol="√m", socket="Roughness", default=0.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="0: polished; above: frosted. Its square is the rms slope m of the facets"),
    Colour(name="tint", socket="Tint", default=(1.0, 1.0, 1.0), low=0.0, high=1.0,
           tip="Colours the surface, as a thin coat of dye does; the colour of the body is Depth Color"),
    Colour(name="depth_colour", socket="Depth Color", default=(1.0, 1.0, 1.0), low=0.0, high=1.0,
           tip="Colour that white light has after Depth; it comes on top of Absorption"),
    Number(name="depth", socket="Depth", default=0.01, low=1e-6, high=1e6, slider=(1e-6, 1000.0), unit="m",
           tip="How thick the piece is, in metres, where it shows Depth Color: thinner is paler, thicker is deeper"),
    Number(name="concentration", socket="Concentration", default=1.0, low=0.0, high=1e6, slider=(0.0, 100.0),
           tip="Factor on all absorption: below 1 weaker, above 1 stronger than the material is"),
    Triple(name="absorption", symbol="σ", socket="Absorption", default=(0.0, 0.0, 0.0), low=0.0, high=1e9,
           slider=(0.0, 1e6), unit="1/m", tip="Measured absorption per metre for red, green and blue"),
    Number(name="scene_scale", socket="Scene Scale", default=0.005, low=1e-9, high=1e9, slider=(1e-6, 1e6), unit="m",
           tip="How many metres of the material a scene unit is, for absorption: 1 for models in metres; "
               "the default takes a default cube for a piece of one centimetre"),
    Number(name="ior", symbol="n_d", socket="IOR", default=1.5, low=1.0, high=10.0, slider=(1.0, 4.0),
           never_zero=True,
           tip="Index of refraction in yellow light, 587.56 nm"),
    Number(name="outside", socket="Outside IOR", default=1.0, low=1.0, high=10.0, slider=(1.0, 4.0),
           never_zero=True,
           tip="Index of what the face is against: 1 for air, 1.333 where it touches water"),
    Number(name="dispersion", socket="Dispersion", default=1.0, low=0.0, high=10.0, slider=(0.0, 5.0),
           realisations=("dispersive",), tip="Strength of the rainbow: 0 none, 1 as measured"),
    Number(name="cauchy_b", symbol="b", socket="Cauchy b", default=0.0, low=-1.0, high=1.0, unit="µm²",
           panel="Dispersion Curve", realisations=("dispersive",),
           tip="Of n = n_d + b (x - x_d) + c (x² - x_d²), x = 1/λ², in µm²"),
    Number(name="cauchy_c", symbol="c", socket="Cauchy c", default=0.0, low=-1.0, high=1.0, unit="µm⁴",
           panel="Dispersion Curve", realisations=("dispersive",),
           tip="Of the same curve, in µm⁴"),
    Choice(name="walls", socket="Thin Walled", key="thin", default="solid", options=("solid", "thin"),
           tip="0: the mesh encloses the body; 1: the mesh is one sheet, such as a pane or a bubble, Thickness thick"),
    Number(name="thickness", socket="Thickness", default=0.004, low=0.0, high=1e6, slider=(0.0, 100.0), unit="m",
           tip="Of a thin wall in metres; EEVEE colours solid bodies by it, too"),
    Number(name="see_through", socket="See-through Shadows", default=1.0, low=0.0, high=1.0, subtype="FACTOR",
           tip="1: shadows are straight and coloured, free of noise; 0: by refracted paths, which need caustics"),
    Direction(name="normal", symbol="N", socket="Normal",
              tip="Shading normal; the surface's own where nothing is plugged in"),
)


class Clear(checked_class("Clear", TABLE)):
    """One clear material; a field a row of TABLE."""
