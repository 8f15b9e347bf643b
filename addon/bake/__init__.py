"""From spectra to RGB curves, fitted parameters, gamut mapping and residuals.  numpy only."""

from .baking import FORMULAS, Bake, bake

__all__ = ["bake", "Bake", "FORMULAS"]
