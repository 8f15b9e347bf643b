"""Spectra and curves as CSV: a line of headings, commas, decimal points, every digit that a number has."""

__all__ = ["spectrum_csv", "curve_csv"]


def spectrum_csv(constants):
    """The measured points of OpticalConstants; :mod:`addon.spectra.readers` reads them back as they are.

    wavelength_nm, n, k; without k where none was measured, unless a reader would
    miss it, and with R in place of both where the normal reflectance was.

    >>> from addon.spectra.optical_constants import load
    >>> spectrum_csv(load("main/Cu/Johnson")).splitlines()[0]
    'wavelength_nm,n,k'
    """
    from ..reflectance.fresnel import conductor
    from ..spectra.readers.points import why_k_is_missing
    if constants.normal_only:
        named = {"R": conductor(1.0, constants.n, 0.0)}
    else:
        has_k = constants.has_k or why_k_is_missing(constants.wavelength_nm, constants.n)
        named = {"n": constants.n, **({"k": constants.k} if has_k else {})}
    return _csv(("wavelength_nm", *named), zip(constants.wavelength_nm, *named.values()))


def curve_csv(bake):
    """The colour over angle of a Bake: cos_theta ascending, and linear r, g, b in the bake's space.

    >>> from addon.bake import bake
    >>> curve_csv(bake("copper")).splitlines()[0]
    'cos_theta,r,g,b'
    """
    curve = bake.fresnel
    return _csv(("cos_theta", "r", "g", "b"), ((c, *rgb) for c, rgb in zip(curve.cos_theta, curve.rgb)))


def _csv(headings, rows):
    lines = [",".join(headings), *(",".join(repr(float(value)) for value in row) for row in rows)]
    return "\n".join(lines) + "\n"
