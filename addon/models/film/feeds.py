"""What feeds a film's thickness where it varies."""

from ..model import Feed
from ..parameters import read, written
from .parameters import TABLE, THICKNESS_GROUP

__all__ = ["feeds", "read_feed"]


def feeds(parameters):
    """The thickness field before the node, where the thickness varies."""
    if parameters.thickness_range is None:
        return ()
    return (Feed(THICKNESS_GROUP, written(parameters, THICKNESS_GROUP), {"Thickness": "Thickness"}),)


def read_feed(fed):
    """{parameter's name: value} that the thickness field holds; nothing where there is none."""
    if THICKNESS_GROUP not in fed:
        return {}
    values, _ = fed[THICKNESS_GROUP]
    return read(TABLE, values, THICKNESS_GROUP)
