"""Verify: renders the probes of every model and realisation on this Blender and holds them against the formulas."""

from .running import checks, verify

__all__ = ["checks", "verify"]
