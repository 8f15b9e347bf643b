"""Measured data: optical constants, illuminants, observers, presets.  numpy only."""
