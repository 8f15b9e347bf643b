"""What of a file may be changed: not what is linked from another, nor its overrides."""

from bpy.app.translations import pgettext_rpt as rpt_

from ...errors import FacetFilmError

__all__ = ["is_editable", "require_editable", "why_locked"]


def require_editable(datablock) -> None:
    """Raise FacetFilmError, with the way out, for a datablock that cannot be changed."""
    if datablock.library is not None:
        raise FacetFilmError("{material} is linked from another file: make it local first (Object, Relations, "
                             "Make Local)", material=datablock.name)
    if datablock.override_library is not None:
        raise FacetFilmError("{material} is a library override, whose nodes and slots belong to another file: make it "
                             "local first (Object, Relations, Make Local)", material=datablock.name)


def why_locked(datablock) -> str:
    """Why a datablock cannot be changed and what to do, or an empty text."""
    try:
        require_editable(datablock)
    except FacetFilmError as error:
        return error.said(rpt_)
    return ""


def is_editable(datablock) -> bool:
    """Whether a datablock belongs to this file, so that it may be changed."""
    return datablock.library is None and datablock.override_library is None
