# SPDX-License-Identifier: GPL-3.0-or-later
"""Facet & Film: measured metals and layered films for Cycles.

Blender loads this folder, or the zip made of it, as an extension; everything is in addon/.
"""

from .addon import register, unregister
from .addon.blender.exporters import glTF2ExportUserExtension

__all__ = ["glTF2ExportUserExtension", "register", "unregister"]
