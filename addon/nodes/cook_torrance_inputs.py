"""The sockets that every realisation of Cook-Torrance shares, in one order that never changes."""

from types import SimpleNamespace

__all__ = ["SLOPE_COUNT", "cook_torrance_inputs"]

SLOPE_COUNT = 4


def cook_torrance_inputs(builder):
    """Add the sockets to the group under construction; return their operands by the paper's names."""
    specular = builder.input(
        "Specular", 1.0, minimum=0.0, maximum=1.0, subtype="FACTOR",
        description="Share s of the light that the facets reflect; the rest d = 1 - s is diffuse")
    diffuse = builder.input(
        "Diffuse Color", (0.8, 0.8, 0.8), "COLOR",
        description="Diffuse reflectance pi Rd, in the paper the reflectance at normal incidence")
    n = builder.input(
        "Refractive Index n", (0.2, 0.92, 1.1), "VECTOR", minimum=0.001, maximum=100.0,
        description="Real part of the complex refractive index for red, green and blue")
    k = builder.input(
        "Extinction k", (3.91, 2.45, 2.14), "VECTOR", minimum=0.0, maximum=100.0,
        description="Imaginary part of the complex refractive index for red, green and blue; 0 for dielectrics")
    slopes = [_slope(builder, j) for j in range(SLOPE_COUNT)]
    gaussian = builder.input(
        "Gaussian", 0.0, minimum=0.0, maximum=1.0, subtype="FACTOR", panel="Model",
        description="0: Beckmann slope distribution; 1: Gaussian slope distribution")
    published = builder.input(
        "Published Scale", 0.0, minimum=0.0, maximum=1.0, subtype="FACTOR", panel="Model",
        description="0: energy-conserving scale; 1: as printed, four times as bright, "
                    "which can reflect more light than arrives")
    gaussian_c = builder.input(
        "Gaussian c", 1.0, minimum=0.0, maximum=1000.0, panel="Model",
        description="The paper's arbitrary factor of the Gaussian distribution, used in the published scale only")
    normal = builder.input("Normal", kind="VECTOR", hide_value=True,
                           description="Shading normal; the surface's own where nothing is plugged in")
    return SimpleNamespace(specular=specular, diffuse=diffuse, n=n, k=k, slopes=slopes, gaussian=gaussian,
                           published=published, gaussian_c=gaussian_c, normal=normal)


def _slope(builder, j):
    m = builder.input(
        f"Slope {j + 1}", (0.2, 0.4, 0.1, 0.6)[j], minimum=0.001, maximum=1.0, subtype="FACTOR", never_zero=True,
        description="Rms slope m of the facets: 0.1 is polished, 0.2 satin, 0.5 rough",
        panel=None if j == 0 else "More Slopes")
    w = builder.input(
        f"Weight {j + 1}", 1.0 if j == 0 else 0.0, minimum=0.0, maximum=1.0, subtype="FACTOR",
        description="Share w of this slope; the shares of all slopes sum to 1",
        panel=None if j == 0 else "More Slopes")
    return m, w
