"""The door for shells: ``python -m addon list``, ``bake copper`` …  Needs numpy, not Blender.

Inside Blender the same commands are ``blender --command facet_film …``.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from .errors import FacetFilmError
from .shell.parser import parser

__all__ = ["main"]


def main(argv: Sequence[str]) -> int:
    """Run one command; the exit status: 0, or 2 with one sentence on stderr for input that cannot be used.

    A verification that is not green ends with 1.

    argv  the words after the program's name

    >>> main(["bake", "coper"])
    2
    """
    try:
        options = parser().parse_args(argv)
    except SystemExit as end:  # argparse has said why
        return end.code or 0
    try:
        result = options.run(options)
        text, status = result if isinstance(result, tuple) else (result, 0)
        print(text, flush=True)
    except FacetFilmError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader has had enough, as in `… | head`
        sys.stderr.close()
        return 0
    return status
