"""What a check is: a material rendered, the formula beside it, and figures that have to stay below their limits."""

from dataclasses import dataclass, field

import numpy as np

__all__ = ["Figure", "Picture", "Outcome", "Check"]


@dataclass(frozen=True)
class Figure:
    """One number of a check.

    name       what it is, in words
    value      as measured
    limit      the most that passes
    per_cent   whether people read it as a percentage
    """

    name: str
    value: float
    limit: float
    per_cent: bool = False

    @property
    def passed(self):
        """Whether it is a number, and at most the limit.

        >>> Figure("rms", 0.01, 0.02).passed, Figure("rms", float("nan"), 0.02).passed
        (True, False)
        """
        return bool(self.value <= self.limit)


@dataclass(frozen=True, eq=False)
class Picture:
    """Reference, render and what they differ by, each ``(rows from the bottom, columns, 3)``, scene-linear."""

    reference: np.ndarray
    render: np.ndarray
    times: float = 10.0
    """Factor on the difference, to see it."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """What a check found."""

    figures: tuple
    picture: Picture | None = None
    details: tuple = ()
    """Rows of a table: texts; the first is the head."""

    @property
    def passed(self):
        """Whether every figure did."""
        return all(figure.passed for figure in self.figures)


@dataclass(frozen=True)
class Check:
    """One thing that is rendered and held against its formula.

    model        name of a model, or "data"
    realisation  one of addon.models.realisations.REALISATIONS, or "" for what is not rendered
    name         unique among the checks of a model and realisation
    what         what is compared with what, in a sentence
    measure      function(realisation, parameters of the material, parameters of the formula) -> Outcome
    parameters   of both
    """

    model: str
    realisation: str
    name: str
    what: str
    measure: object
    parameters: dict = field(default_factory=dict)

    def run(self, **rendered):
        """The Outcome; with other parameters for the material than for the formula it has to fail."""
        return self.measure(self.realisation, {**self.parameters, **rendered}, self.parameters)

    @property
    def title(self):
        """Model, realisation and name in one line."""
        return ", ".join(part for part in (self.model, self.realisation, self.name) if part)
