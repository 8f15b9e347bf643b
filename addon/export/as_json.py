"""JSON as every door writes it."""

import json

__all__ = ["json_text"]


def json_text(value):
    """Dicts, lists, numbers and texts as JSON text, an item a line; numbers that JSON lacks are refused.

    >>> json_text({"f0": (0.9, 0.6)}).split()
    ['{', '"f0":', '[', '0.9,', '0.6', ']', '}']
    """
    return json.dumps(value, ensure_ascii=False, indent=1, allow_nan=False) + "\n"
