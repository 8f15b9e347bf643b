"""Finishes: what was done to a surface, whatever it is made of.

A finish says how rough a surface is and, where it leaves marks, which node group varies that over the surface.  It goes
on the materials of every model whose table has a roughness.  What makes its group is a module here with a TABLE of
inputs, what it DRIVES, and a build().  DRIVES names sockets of the material's own group: an output of the group feeds
each, and where it has an input of the same name, that takes the socket's value and gives it back, varied.
"""

from .finish import Finish, all_finishes, find, names, of_group

__all__ = ["Finish", "all_finishes", "find", "names", "of_group"]
