"""Our datablocks in the open file: node groups, materials, ramps."""

from .. import on_demand

__getattr__ = on_demand(__name__)
