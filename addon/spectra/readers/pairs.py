"""The other half of n and k where it lies in a file of its own: Au.eta.spd with Au.k.spd, n.txt with k.txt."""

import os
import re

from .text import text_of_file

__all__ = ["partner_of", "partner_names", "HALVES"]

HALVES = {
    "n": ("eta", "n", "nr", "ior", "index"),
    "k": ("k", "kappa", "ext", "extinction"),
    "α": ("alpha", "absorption"),
}
"""Words of a file's name that tell which half it holds."""
OTHERS = {"n": ("k", "α"), "k": ("n",), "α": ("n",)}
COUNTED = re.compile(r"^\d+[_\- ]+")


def partner_names(name, half):
    """What the file with the other half may be called, in small letters, without a number in front.

    >>> sorted(partner_names("Au.eta.spd", "n"))[:2], "k.txt" in partner_names("n.txt", "n")
    (['au.absorption.spd', 'au.alpha.spd'], True)
    """
    plain = COUNTED.sub("", name.lower())
    found = set()
    for word in HALVES[half]:
        for match in re.finditer(rf"(?<![a-z]){word}(?![a-z])", plain):
            for other in OTHERS[half]:
                found |= {plain[: match.start()] + swapped + plain[match.end() :] for swapped in HALVES[other]}
    return found


def partner_of(text, half):
    """The Text of the only file beside a Text's own that is called as the other half would be, or None."""
    if text.path is None:
        return None
    names = partner_names(text.name, half)
    folder = os.path.dirname(os.path.abspath(text.path))
    try:
        beside = sorted(os.listdir(folder)) if names else []
    except OSError:
        return None
    found = [name for name in beside if COUNTED.sub("", name.lower()) in names and name != text.name]
    if len(found) != 1:
        return None
    partner = text_of_file(os.path.join(folder, found[0]))
    partner.choose = text.choose
    return partner
