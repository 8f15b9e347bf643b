"""Panels and menus, a file each, and what they share."""
