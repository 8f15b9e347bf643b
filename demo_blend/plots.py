"""The papers' plots, drawn from the product's own functions: no renderer, no numbers of their own.

Cook and Torrance 1982, figures 3, 4 and 5; the layered model's colour over its thickness and over the exit angle.
"""

import numpy as np
from matplotlib import rcParams
from matplotlib.figure import Figure as Canvas

from addon.bake import reflected, ways
from addon.bake.gamut import map_colours
from addon.bake.srgb import bytes_of
from addon.catalogue.resolving import resolve
from addon.models.cook_torrance import formulas as ct
from addon.models.layered_rgb import formulas as layered
from addon.reflectance.directions import direction
from addon.spectra import illuminants, observers

from .job import Figure

WAVELENGTHS = observers.WAVELENGTH_NM
CHANNELS = (("red", "#d9412b"), ("green", "#2f9e44"), ("blue", "#2f6fd0"))
LAYER_NM = np.array(layered.WAVELENGTHS)
INDEX = np.array([1.4, 1.45, 1.6])
E0, E1 = 90.0, 170.0
UP, EAST, NORTH = np.eye(3)[2], np.eye(3)[0], np.eye(3)[1]

rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.titlesize": 10,
                 "axes.titlelocation": "left", "svg.hashsalt": "facet-film"})


def _write(job, canvas, name):
    """A plot as a PNG that says where it is from."""
    path = job.pictures / name
    path.parent.mkdir(parents=True, exist_ok=True)
    canvas.savefig(path, dpi=max(20, round(110 * job.scale)), metadata={"Source": f"Made by {job.generator}",
                                                                       "Software": None})
    job.written.append(path)


def lobes(job):
    """Figure 3: the lobe R over the angle of the viewer, light from 30°, for Beckmann's and the Gaussian D."""
    light = direction(np.radians(30.0), np.pi)
    angles = np.radians(np.linspace(-89.9, 89.9, 1441))
    views = np.stack([direction(abs(angle), 0.0 if angle > 0 else np.pi) for angle in angles])
    canvas = Canvas(figsize=(9.0, 4.8), layout="constrained")
    axes = canvas.subplots(2, 2, subplot_kw={"projection": "polar"}).ravel()
    for ax, letter, (name, distribution, m) in zip(axes, "abcd", (
            ("Beckmann", "beckmann", 0.2), ("Gaussian", "gaussian", 0.2),
            ("Beckmann", "beckmann", 0.6), ("Gaussian", "gaussian", 0.6))):
        rho = ct.cook_torrance(UP, views, light, slopes=((m, 1.0),), index=np.array([1e6]), extinction=np.array([0.0]),
                               distribution=distribution)[..., 0]
        ax.fill(angles, rho, color="#c7793f", alpha=0.35, lw=0)
        ax.plot(angles, rho, color="#9a5320", lw=1.4)
        peak = 1.08 * rho.max()
        ax.annotate("", xy=(0, 0), xytext=(np.radians(-30.0), peak), arrowprops={"arrowstyle": "->", "color": "0.4"})
        ax.plot(np.radians([30.0, 30.0]), [0, peak], color="0.4", lw=0.7, ls=":")
        ax.set(thetamin=-90, thetamax=90, theta_zero_location="N", theta_direction=-1, ylim=(0, 1.1 * peak))
        ax.set_title(f"{letter}  {name}, m = {m:g}; at most {rho.max():.3g} /sr")
        ax.tick_params(labelsize=7)
        ax.set_yticklabels([])
    _write(job, canvas, "plots_lobes.png")


def copper_spectra(job):
    """Figure 4: copper's reflectance at normal incidence, and D65 before and after the mirror."""
    constants = resolve("copper").constants
    n, k = constants.at(WAVELENGTHS)
    mirror = reflected.mirror_spectra(np.array([1.0]), n, k)[0]
    daylight = illuminants.power("D65")
    canvas = Canvas(figsize=(9.0, 3.4), layout="constrained")
    left, right = canvas.subplots(1, 2)
    left.plot(WAVELENGTHS, mirror, color="#9a5320")
    left.set(title=f"a  A copper mirror at normal incidence ({constants.dataset})", ylabel="reflectance F", ylim=(0, 1))
    right.plot(WAVELENGTHS, daylight, color="0.35", label="D65")
    right.plot(WAVELENGTHS, daylight * mirror, color="#9a5320", label="D65 after the mirror")
    right.set(title="b  The light before and after", ylabel="relative power", ylim=(0, None))
    right.legend(frameon=False)
    for ax in (left, right):
        ax.set(xlabel="wavelength in nm", xlim=(380, 780))
    _write(job, canvas, "plots_copper.png")


def copper_over_angle(job):
    """Figure 5: copper's reflectance over wavelength and angle, and its colour over angle, exact and by the shift."""
    constants = resolve("copper").constants
    n, k = constants.at(WAVELENGTHS)
    degrees = np.linspace(0.0, 90.0, 91)
    spectra = reflected.mirror_spectra(np.cos(np.radians(degrees)), n, k)
    canvas = Canvas(figsize=(9.0, 4.2), layout="constrained")
    grid = canvas.add_gridspec(2, 2, width_ratios=(1.25, 1.0))
    surface = canvas.add_subplot(grid[:, 0], projection="3d")
    surface.plot_surface(*np.meshgrid(WAVELENGTHS[::4], degrees[::3]), spectra[::3, ::4], cmap="copper", vmin=-0.3,
                         vmax=1.1, lw=0.3, edgecolor="#00000050", rstride=1, cstride=1)
    surface.set(xlabel="wavelength in nm", ylabel="angle θ in degrees", zlim=(0, 1))
    surface.set_title("a  Reflectance of a copper mirror")
    surface.view_init(28, -58)
    found = {way.name: way for way in ways("copper").ways}
    for j, (letter, name, title) in enumerate((("b", "exact", "exact"), ("c", "colour_shift", "cheap colour shift"))):
        ax = canvas.add_subplot(grid[j, 1])
        rgb = np.array(found[name].rgb)
        for (_, colour), values in zip(CHANNELS, rgb.T):
            ax.plot(np.arange(90), values, color=colour, lw=1.2)
        ax.imshow(bytes_of(map_colours(rgb)[0])[None], extent=(0, 90, 0.0, 0.32), aspect="auto")
        off = f", up to {found[name].delta_e_2000_max:.0f} CIEDE2000 off" if name != "exact" else ""
        ax.set(xlim=(0, 90), ylim=(0, 1.05), title=f"{letter}  Colour, {title}{off}",
               ylabel="linear R, G, B")
    ax.set_xlabel("angle θ in degrees; the strip shows the colour")
    _write(job, canvas, "plots_copper_angle.png")


def ways_to_colour(job):
    """The largest CIEDE2000 over angle of each way to a metal's colour."""
    metals = ("aluminium", "silver", "gold", "copper", "brass", "bronze", "titanium", "tungsten", "titanium_nitride",
              "purple_gold")
    canvas = Canvas(figsize=(9.0, 3.4), layout="constrained")
    ax = canvas.subplots()
    found = [{way.name: way for way in ways(metal).ways} for metal in metals]
    shown = ("normal_reflectance", "colour_shift", "schlick", "three_wavelengths")
    for j, (name, colour) in enumerate(zip(shown, ("#b08d57", "#7a6a5a", "#4c78a8", "#c44e52"))):
        ax.bar(np.arange(len(metals)) + 0.2 * (j - 1.5), [f[name].delta_e_2000_max for f in found], 0.19, color=colour,
               label=found[0][name].title)
    ax.set_xticks(np.arange(len(metals)), [metal.replace("_", "\n") for metal in metals])
    ax.set(ylabel="largest CIEDE2000 over angle", title="How far each way to a metal's colour is from the exact one")
    ax.legend(frameon=False, fontsize=8)
    _write(job, canvas, "plots_ways.png")


def _colours(values):
    """Values of red, green and blue as colours of a strip; the brightest is white's height, by one scale for all."""
    return bytes_of(values / values.max())


def layer_thickness(job):
    """The layered model's colour over its thickness: the diffuse albedo, and ρ at its peak."""
    thickness = np.linspace(0.0, 600.0, 601)
    cosines = layered.inner_products(UP, UP, UP, UP, INDEX)
    canvas = Canvas(figsize=(9.0, 4.6), layout="constrained")
    axes = canvas.subplots(2, 1, sharex=True)
    for ax, values, label in (
            (axes[0], layered.rho_d_eq16(INDEX, thickness, LAYER_NM), "diffuse albedo, eq. 16"),
            (axes[1], layered.layered_specular(cosines, INDEX, thickness, LAYER_NM, E0, E1),
             "ρ at 0° in 1/sr, eq. 5")):
        for j, (name, colour) in enumerate(CHANNELS):
            ax.plot(thickness, values[:, j], color=colour, lw=1.2, label=f"{name}, {LAYER_NM[j]:g} nm, n {INDEX[j]:g}")
        top, bottom = values.max() * 1.05, -0.22 * values.max()
        ax.imshow(_colours(values)[None], extent=(0, 600, bottom, 0.0), aspect="auto")
        ax.set(ylim=(bottom, top), ylabel=label)
    axes[0].legend(frameon=False, ncols=3, loc="lower left", bbox_to_anchor=(0.0, 1.0))
    axes[1].set_xlabel("thickness d in nm; the strip shows the colour")
    _write(job, canvas, "plots_layer_thickness.png")


def layer_exit_angle(job, polar=10.0, thickness=92.0):
    """ρ over the exit angle for light from 10°, and boundaries at 0°, 5°, 10° and 14° to each other."""
    light = direction(np.radians(polar), np.pi)
    degrees = np.linspace(-40.0, 70.0, 661)
    views = np.stack([direction(np.radians(angle), 0.0) for angle in degrees])
    canvas = Canvas(figsize=(9.0, 6.4), layout="constrained")
    axes = canvas.subplots(4, 1, sharex=True)
    for ax, deviation in zip(axes, (0.0, 5.0, 10.0, 14.0)):
        n1 = layered.tilted_normal(UP, EAST, NORTH, np.radians(deviation), 0.0)
        cosines = layered.inner_products(light, views, UP, n1, INDEX)
        rho = layered.layered_specular(cosines, INDEX, thickness, LAYER_NM, E0, E1)
        for j, (_, colour) in enumerate(CHANNELS):
            ax.plot(degrees, rho[:, j], color=colour, lw=1.2)
        ax.imshow(_colours(rho)[None], extent=(-40, 70, -0.3 * rho.max(), 0.0), aspect="auto")
        ax.axvline(polar, color="0.6", lw=0.8)
        ax.set(ylim=(-0.3 * rho.max(), 1.05 * rho.max()), ylabel="ρ in 1/sr", title=f"deviation {deviation:g}°")
    axes[-1].set_xlabel(f"exit angle in degrees; light from {polar:g}°, its mirror direction in grey; "
                        f"d = {thickness:g} nm")
    _write(job, canvas, "plots_layer_exit_angle.png")


FIGURES = (
    Figure("plots_lobes", "Cook and Torrance, figure 3: lobes", 2.0, lobes),
    Figure("plots_copper", "Cook and Torrance, figure 4: copper and D65", 2.0, copper_spectra),
    Figure("plots_copper_angle", "Cook and Torrance, figure 5: copper over angle", 3.0, copper_over_angle),
    Figure("plots_ways", "Ways to a metal's colour", 2.0, ways_to_colour),
    Figure("plots_layer_thickness", "Layered RGB: colour over thickness", 2.0, layer_thickness),
    Figure("plots_layer_exit_angle", "Layered RGB: ρ over the exit angle", 2.0, layer_exit_angle),
)
