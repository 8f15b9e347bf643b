"""The asset library, and small pictures of presets."""

from .. import on_demand

__getattr__ = on_demand(__name__)
