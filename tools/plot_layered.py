"""Draws what the layered RGB model does: python -m tools.plot_layered --out out

layered_rgb_thickness.png   diffuse albedo and specular peak over thickness, per channel, with their colour
layered_rgb_exit_angle.png  ρ (N.L) over the exit angle, for parallel boundaries and three deviations
"""

import argparse
import math
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from addon.reflectance import layered_rgb as layered  # noqa: E402
from addon.reflectance.directions import direction  # noqa: E402

CHANNELS = (("red", "tab:red"), ("green", "tab:green"), ("blue", "tab:blue"))
UP = np.array([0.0, 0.0, 1.0])
EAST, NORTH = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
WAVELENGTHS = np.array(layered.WAVELENGTHS)
INDEX = np.array([1.4, 1.45, 1.6])
E0, E1 = 90.0, 170.0


def over_thickness():
    """Figure of ρd and of ρ at its peak over thicknesses from 0 to 600 nm."""
    thickness = np.linspace(0.0, 600.0, 601)
    diffuse = layered.rho_d_eq16(INDEX, thickness, WAVELENGTHS)
    cosines = layered.inner_products(UP, UP, UP, UP, INDEX)
    specular = layered.layered_specular(cosines, INDEX, thickness, WAVELENGTHS, E0, E1)
    figure, axes = plt.subplots(2, 1, figsize=(8, 6), sharex=True, constrained_layout=True)
    for ax, values, label in ((axes[0], diffuse, "diffuse albedo ρd, eq. 16 with the ½"),
                              (axes[1], specular, "ρ at normal incidence, 1/sr, eq. 5")):
        for k, (name, colour) in enumerate(CHANNELS):
            ax.plot(thickness, values[:, k], color=colour,
                    label=f"{name}, {WAVELENGTHS[k]:g} nm, index {INDEX[k]:g}")
        strip = np.clip(values / values.max(), 0.0, 1.0) ** (1 / 2.2)
        low, high = ax.get_ylim()
        ax.imshow(strip[None], extent=(0, 600, low - 0.12 * (high - low), low), aspect="auto")
        ax.set_ylim(low - 0.12 * (high - low), high)
        ax.set_ylabel(label)
    axes[0].legend(loc="upper right")
    axes[1].set_xlabel("thickness d in nm; the strip below shows the colour")
    return figure


def over_exit_angle(polar=10.0, thickness=92.0):
    """Figure of ρ (N.L) over the exit angle for light from 10°, deviations of 0°, 5°, 10° and 14°."""
    light = direction(math.radians(polar), math.pi)
    angles = np.linspace(-85.0, 85.0, 681)
    views = np.stack([direction(math.radians(angle), 0.0) for angle in angles])
    figure, axes = plt.subplots(4, 1, figsize=(8, 10), sharex=True, constrained_layout=True)
    for ax, deviation in zip(axes, (0.0, 5.0, 10.0, 14.0)):
        n1 = layered.tilted_normal(UP, EAST, NORTH, math.radians(deviation), 0.0)
        cosines = layered.inner_products(light, views, UP, n1, INDEX)
        rho = layered.layered_specular(cosines, INDEX, thickness, WAVELENGTHS, E0, E1)
        r, t = layered.layered_lobes(cosines, INDEX, E0, E1)
        for k, (name, colour) in enumerate(CHANNELS):
            ax.plot(angles, rho[:, k], color=colour, label=f"ρ, {name}")
            ax.plot(angles, 0.5 * (r + t)[:, k], color=colour, lw=0.8, ls=":",
                    label="(R + T)/2, without interference" if k == 0 else None)
        ax.axvline(polar, color="0.6", lw=0.8)
        ax.set_title(f"deviation {deviation:g}°", loc="left", fontsize=10)
        ax.set_ylabel("ρ in 1/sr")
    axes[0].legend(loc="upper left", fontsize=8)
    axes[-1].set_xlabel(f"exit angle in degrees; light from {polar:g}°, its mirror direction in grey; "
                        f"d = {thickness:g} nm")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=Path("out"), help="folder for the pictures")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for name, draw in (("thickness", over_thickness), ("exit_angle", over_exit_angle)):
        path = out / f"layered_rgb_{name}.png"
        draw().savefig(path, dpi=110)
        print(path)


if __name__ == "__main__":
    main()
