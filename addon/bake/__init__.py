"""From spectra to RGB curves, fitted parameters, gamut mapping and residuals.  numpy only."""

from .baking import FORMULAS, Bake, bake
from .checking import Check, Spread, check, spread
from .paper import Ways, ways

__all__ = ["bake", "Bake", "check", "Check", "spread", "Spread", "ways", "Ways", "FORMULAS"]
