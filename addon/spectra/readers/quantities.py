"""n and k from what was measured: ε1 and ε2, complex numbers, absorption, transmittance, reflectance."""

import re

import numpy as np

from .headings import LARGEST_ANGLE, PER_LENGTH
from .points import Points

__all__ = ["n_and_k_of", "index_of_permittivity"]

LEAST_PERCENT = 2.0
THICKNESS = re.compile(r"(\d+(?:[.,]\d+)?)\s*(nm|µm|μm|um|mm|cm)\b", re.IGNORECASE)
NM_OF_LENGTH = {"nm": 1.0, "µm": 1e3, "μm": 1e3, "um": 1e3, "mm": 1e6, "cm": 1e7}


def index_of_permittivity(e1, e2):
    """(n, k) of a relative permittivity ε1 + iε2: (n + ik)² = ε.

    n = √((|ε| + ε1)/2), k = ε2/(2n), which for ε1 < 0 keeps its digits as √((|ε| − ε1)/2).

    >>> [float(value.round(6)) for value in index_of_permittivity(np.array(-1.0), np.array(0.0))]
    [0.0, 1.0]
    """
    permittivity = np.empty(np.shape(e1), complex)
    permittivity.real, permittivity.imag = e1, e2
    with np.errstate(all="ignore"):
        root = np.sqrt(permittivity)
    return root.real, root.imag


def n_and_k_of(text, roles, alone=False):
    """The Points that follow from quantities, or None where half of a pair is missing.

    roles  Series by their role
    alone  whether n may be all there is
    """
    if "n+ik" in roles:
        series = roles["n+ik"]
        return _both(text, series, series.values.real, series.values.imag, "complex numbers n − ik")
    if "ε1+iε2" in roles:
        series = roles["ε1+iε2"]
        if not np.iscomplexobj(series.values):
            text.refuse(
                None,
                f"has one column of {series.name!r}: epsilon is complex, and its other half is missing",
                "ε1 and ε2, or complex numbers",
            )
        return _from_permittivity(text, series, series.values.real, series.values.imag)
    if {"n", "k"} <= set(roles):
        return _n_and_k(text, roles["n"], roles["k"])
    if {"ε1", "ε2"} <= set(roles):
        one, two = roles["ε1"], roles["ε2"]
        if not np.array_equal(one.wavelength_nm, two.wavelength_nm):
            order = np.argsort(two.wavelength_nm)
            return _from_permittivity(
                text, one, one.values, np.interp(one.wavelength_nm, two.wavelength_nm[order], two.values[order])
            )
        return _from_permittivity(text, one, one.values, two.values)
    for half in ("ε1", "ε2"):
        if half in roles:
            text.refuse(None, f"has {half} alone, half of a pair", "ε1 and ε2")
    if "R" in roles:
        if set(roles) & {"n", "k"}:
            text.refuse(
                None,
                "has R and " + " and ".join(sorted(set(roles) & {"n", "k"})),
                "R alone, or n and k; or n, n and k, or R",
            )
        return [_reflectance(text, roles["R"])]
    if "n" in roles:
        return _n_and_absorption(text, roles, alone)
    if "k" in roles or "α" in roles:
        return None
    for role, what in (("T", "transmittance"), ("A", "absorbance")):
        if role in roles:
            text.refuse(
                None, f"has the {what} alone: no reflectance follows without n and the thickness", "n, n and k, or R"
            )
    names = ", ".join(repr(series.name) for series in roles.values())[:80]
    return text.refuse(None, f"the columns {names} name no n, k or R", "headings such as 'wavelength_nm, n, k'")


def _n_and_k(text, n, k):
    values = _positive(text, k, k.values, "k")
    return [Points("n", n.wavelength_nm, n.values.real, n.lines), Points("k", k.wavelength_nm, values, k.lines)]


def _positive(text, series, values, what):
    """Values of k or ε2 with the sign of n + ik, where all of them have that of n − ik."""
    seen = values[np.isfinite(values)]
    if seen.size and np.median(seen) < 0.0 and seen.max() <= 1e-3 * np.abs(seen).max():
        text.assume(f"{what} is below 0 throughout: read as n − ik, and its sign turned")
        return np.maximum(-values, 0.0)
    return values


def _both(text, series, n, k, what):
    k = _positive(text, series, k, "the imaginary part")
    return [Points("n", series.wavelength_nm, n, series.lines), Points("k", series.wavelength_nm, k, series.lines)]


def _from_permittivity(text, series, e1, e2):
    e2 = _positive(text, series, e2, "ε2")
    low = (e2 < 0.0) & (e2 >= -0.005)
    if low.any():
        text.assume(f"ε2 below 0 at {int(low.sum())} points taken as 0")
        e2 = np.where(low, 0.0, e2)
    n, k = index_of_permittivity(e1, e2)
    text.assume("n and k from the permittivity: (n + ik)² = ε1 + iε2")
    return [
        Points("n", series.wavelength_nm, np.where(np.isnan(e1), np.nan, np.maximum(n, 1e-9)), series.lines),
        Points("k", series.wavelength_nm, k, series.lines),
    ]


def _reflectance(text, series):
    """Points of R in 0 to 1: from percent where the heading says so, or where all are above 1."""
    if series.angle > LARGEST_ANGLE:
        text.refuse(None, f"R is at {series.angle:g}°", "the reflectance at normal incidence, or near it")
    values = series.values.real
    seen = values[np.isfinite(values)]
    if series.unit == "%" and seen.size and 0.0 < seen.max() <= LEAST_PERCENT:
        percent = (
            text.ask(
                series.lines[0],
                f"R, {seen.min():g} to {seen.max():g}, is headed with % and small throughout: it may be",
                ("in %", "a share"),
                "numbers up to 100, or a heading without %",
            )
            == "in %"
        )
    else:
        percent = series.unit == "%" or bool(seen.size and (seen > 1.0).all() and seen.max() > LEAST_PERCENT)
    if percent and series.unit != "%":
        text.assume("R taken in %, as all of it is above 1")
    return Points("R", series.wavelength_nm, values / 100.0 if percent else values, series.lines)


def _n_and_absorption(text, roles, alone):
    """Points of n, and of k from an absorption coefficient or a transmittance where they are there."""
    n = roles["n"]
    found = [Points("n", n.wavelength_nm, n.values.real, n.lines)]
    if "α" in roles:
        alpha = roles["α"]
        per_nm = PER_LENGTH.get(alpha.unit)
        if per_nm is None:
            unit = text.ask(
                None,
                "the absorption coefficient α has no unit: it may be in",
                ("1/cm", "1/m"),
                "a heading such as alpha (1/cm)",
            )
            per_nm = PER_LENGTH[unit]
        text.assume("k from the absorption coefficient: k = αλ/4π")
        return [
            *found,
            Points(
                "k", alpha.wavelength_nm, alpha.values.real * per_nm * alpha.wavelength_nm / (4.0 * np.pi), alpha.lines
            ),
        ]
    if "T" in roles:
        thickness = THICKNESS.search(roles["T"].name) or next(
            (match for line in text.lines[:40] if "thick" in line.lower() and (match := THICKNESS.search(line))), None
        )
        if thickness:
            return [*found, _k_of_transmittance(text, n, roles["T"], thickness)]
        text.assume("T is left aside: no thickness is named")
    return found if alone else None


def _k_of_transmittance(text, n, series, thickness):
    """k of a plate's transmittance: T = (1 − R)²·τ/(1 − R²τ²), τ = exp(−4πkd/λ); internal T is τ itself."""
    length = float(thickness[1].replace(",", ".")) * NM_OF_LENGTH[thickness[2].lower()]
    percent = series.unit == "%" or np.nanmax(series.values.real, initial=0.0) > LEAST_PERCENT
    t = series.values.real / (100.0 if percent else 1.0)
    tau = t
    if "internal" not in series.name.lower() and "τ" not in series.name:
        order = np.argsort(n.wavelength_nm)
        index = np.interp(series.wavelength_nm, n.wavelength_nm[order], n.values.real[order])
        r = ((index - 1.0) / (index + 1.0)) ** 2
        b = (1.0 - r) ** 2
        tau = 2.0 * t / (b + np.sqrt(b * b + 4.0 * t * t * r * r))
    with np.errstate(divide="ignore", invalid="ignore"):
        k = -np.log(np.clip(tau, 1e-300, 1.0)) * series.wavelength_nm / (4.0 * np.pi * length)
    text.assume(f"k from the transmittance of {length / 1e6:g} mm")
    return Points("k", series.wavelength_nm, k, series.lines)
