"""From spectra to RGB curves, fitted parameters, gamut mapping and residuals.  numpy only."""

from importlib import import_module

__all__ = ["bake", "Bake", "check", "Check", "spread", "Spread", "ways", "Ways", "preview", "preview_text",
           "Preview", "FORMULAS"]

PLACES = {"bake": "baking", "Bake": "baking", "FORMULAS": "baking", "check": "checking", "Check": "checking",
          "spread": "checking", "Spread": "checking", "ways": "paper", "Ways": "paper",
          "preview": "previewing", "preview_text": "previewing", "Preview": "previewing"}
"""Name -> module, loaded with its first use: who bakes waits for nothing else."""


def __getattr__(name):
    if name not in PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{PLACES[name]}", __name__), name)
