"""The finishes, and what each says of a surface.  Read when Blender starts, so it loads nothing."""

from types import MappingProxyType

from ..errors import FacetFilmError, choice

__all__ = ["Finish", "all_finishes", "find", "names", "of_group"]

WARD = "G. J. Ward, SIGGRAPH 1992, Table 1"


class Finish:
    """What was done to a surface.

    name        what scripts call it
    title       what people call it
    note        one sentence on what it looks like
    slopes      (m, w) pairs: rms slope of the facets, and its share
    source      where the slopes are from
    chosen      whether they are chosen by eye, and the source says only what came near
    anisotropy  a in [0, 1): the slopes are m/√(1 − 0.9 a) across the marks, m √(1 − 0.9 a) along them
    group       id of the node group that leaves the marks, or ""
    controls    {socket: value} of it where they are not its defaults
    """

    def __init__(self, name, title, note, slopes, source, *, chosen=False, anisotropy=0.0, group="",
                 controls=MappingProxyType({})):
        self.name, self.title, self.note, self.slopes, self.source = name, title, note, slopes, source
        self.chosen, self.anisotropy, self.group, self.controls = chosen, anisotropy, group, controls

    @property
    def roughness(self):
        """√m of all facets together, m² = Σ wj mj².

        >>> round(find("paper_1982").roughness, 3), round(find("satin").roughness, 3)
        (0.545, 0.361)
        """
        return sum(w * m * m for m, w in self.slopes) ** 0.25


FINISHES = (
    Finish("polished", "Polished", "Smooth, with clear reflections that are soft at their edges", ((0.05, 1.0),),
           "Chosen by eye: as the smoother direction of Ward's rolled brass", chosen=True),
    Finish("satin", "Satin", "An even sheen without marks", ((0.13, 1.0),),
           f"Measured: moulded plastic, alpha 0.13 ({WARD})"),
    Finish("brushed", "Brushed", "Parallel streaks, and highlights drawn out across them", ((0.0894, 1.0),),
           f"Measured: rolled brass, alpha 0.05 along and 0.16 across the marks ({WARD}); the streaks by eye",
           anisotropy=0.764, group="finish_brushed"),
    Finish("brushed_circular", "Brushed, Circular", "Streaks in circles, as from a lathe or on the foot of a pan",
           ((0.0894, 1.0),), f"Measured: as brushed ({WARD}); the circles by eye",
           anisotropy=0.764, group="finish_brushed_circular"),
    Finish("sandblasted", "Sandblasted", "Matt, with an even, fine grain", ((0.3, 1.0),), "Chosen by eye", chosen=True,
           group="finish_sandblasted"),
    Finish("hammered", "Hammered", "Shallow dimples side by side, each with its own highlight", ((0.09, 1.0),),
           "Chosen by eye", chosen=True, group="finish_hammered"),
    Finish("cast", "Cast", "The coarse, dull skin of a sand mould, with pits", ((0.25, 1.0),), "Chosen by eye",
           chosen=True, group="finish_cast"),
    Finish("scratched", "Scratched", "Smooth, with deep scratches and hairlines in all directions", ((0.05, 1.0),),
           "Chosen by eye", chosen=True, group="finish_scratched"),
    Finish("smudged", "Smudged", "Smooth, with fingerprints and the marks of wiping", ((0.03, 1.0),),
           "Chosen by eye", chosen=True, group="finish_smudged"),
    Finish("worn_edges", "Worn Edges", "Dull and tarnished, rubbed bright at the edges", ((0.25, 1.0),),
           "Chosen by eye", chosen=True, group="finish_worn_edges"),
    Finish("paper_1982", "Rough, 1982", "The rough finish of the paper's copper vase", ((0.4, 0.4), (0.2, 0.6)),
           "R. L. Cook, K. E. Torrance, A Reflectance Model for Computer Graphics, 1982, figure 6: two slopes"),
)


def all_finishes():
    """Every Finish, in the order in which they are shown."""
    return FINISHES


def names():
    """The names of all finishes.

    >>> len(names()) >= 10, names()[:3]
    (True, ('polished', 'satin', 'brushed'))
    """
    return tuple(finish.name for finish in FINISHES)


def find(name):
    """The Finish of this name or title, small and capital letters alike.

    Raises FacetFilmError with the nearest names.

    >>> find("Worn Edges").name
    'worn_edges'
    >>> find("bruhsed")
    Traceback (most recent call last):
    ...
    addon.errors.FacetFilmError: finish 'bruhsed' is unknown; did you mean 'brushed' or 'brushed_circular'? \
Valid: 'polished', 'satin', 'brushed', 'brushed_circular', 'sandblasted', 'hammered', 'cast', 'scratched', \
'smudged', 'worn_edges', 'paper_1982'.
    """
    if not isinstance(name, str):
        raise FacetFilmError("A finish is called by its name, such as 'brushed', not {value!r}.", value=name)
    plain = {_plain(word): finish for finish in FINISHES for word in (finish.name, finish.title)}
    return plain.get(_plain(name)) or {finish.name: finish for finish in FINISHES}[choice("finish", name, names())]


def of_group(identifier):
    """The Finish whose marks the group with this id leaves, or None."""
    return next((finish for finish in FINISHES if identifier and finish.group == identifier), None)


def _plain(name):
    return "_".join(name.lower().replace(",", " ").replace("-", " ").replace("_", " ").split())
