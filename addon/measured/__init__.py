"""Measured BRDFs: readers, and fits of the models to them.  numpy only."""

from .fit import Fit
from .fitting import fit, fit_steps
from .reading import SUFFIXES, read_brdf

__all__ = ["SUFFIXES", "Fit", "fit", "fit_steps", "read_brdf"]
