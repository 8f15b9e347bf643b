"""Panels and menus, a file each, and what they share."""

from .. import on_demand

__getattr__ = on_demand(__name__)
