"""What a fit gives: parameters, how far off they are, and what to think of it."""

import dataclasses
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..bake.baking import FORMULAS
from ..bake.colour import lab
from ..catalogue.presets import Preset
from ..models.fitted import UP
from ..models.making import ANY_RENDERER, made
from .ball import below, displayed, exposure_of
from .lights import HELD_OUT

__all__ = ["ALIKE", "GOOD", "POOR", "Fit", "report_of"]

SEEN = 0.1
"""What two means differ by at least that are told apart."""
ALIKE, GOOD, POOR = 1.0, 2.0, 3.0
"""Mean CIEDE2000 up to which a fit is alike, good, and from which the model cannot."""
GRAZING = np.radians(60.0)
BRIGHT = 1.0
"""Exposed luminance from which a pixel is in a highlight."""
REASONS = {
    "colour": "its colour changes with the angle in another way than one Fresnel term on facets does",
    "grazing": "towards grazing it reflects otherwise than facets do",
    "highlight": "its highlights have another shape than facets of a few slopes make, as those of flakes",
    "body": "away from its highlights it is not evenly diffuse, as where fibres or flakes send light back",
}


@dataclasses.dataclass(frozen=True, eq=False)
class Fit:
    """A fitted model.

    file, title, form  of the measurement: "RGL", "MERL" or "points"
    model              name of the fitted model
    fresnel            "f0", "n_k" or "curve"
    parameters         the model's checked parameters
    mean, p95          CIEDE2000 of a ball under a surrounding that was not fitted to: mean, and what 95 % of its pixels
                       are below
    worst_degrees      the angle to the normal that it is viewed at where it is worst
    worst              the mean there
    standard           {formula: the mean as Standard renders it} for Blender 5's conductor Fresnel, "exact", and for
                       "blender-4.5"; Reference renders the formula itself
    used, rejected     samples
    reason             why the model cannot, "" where it can
    tried              {fresnel: mean colour difference under the surroundings that were fitted to}
    notes              what was assumed of the file
    images             the ball's exposed linear RGB, measured and fitted, ``(rings, around, 3)`` each, in which 4 is
                       shown as white
    """

    file: str
    title: str
    form: str
    model: str
    fresnel: str
    parameters: Any
    mean: float
    p95: float
    worst_degrees: float
    worst: float
    standard: Mapping[str, float]
    used: int
    rejected: int
    reason: str
    tried: Mapping[str, float]
    notes: tuple[str, ...]
    images: tuple[np.ndarray, np.ndarray]

    @property
    def verdict(self) -> str:
        """"alike", "good", "fair", or why this model cannot."""
        if self.mean <= ALIKE:
            return "alike"
        if self.mean <= GOOD:
            return "good"
        return "fair" if self.mean <= POOR else f"this model cannot, because {self.reason}"

    def said(self) -> str:
        """What it was fitted from and how well, in a sentence or two."""
        said = (f"Fitted to {self.title} ({self.file}). Under a light that was not fitted to, CIEDE2000 is "
                f"{self.mean:.2f} on average and below {self.p95:.1f} in 95 % of the picture: {self.verdict}.")
        return f"{said} {self.said_of_standard()}".strip()

    def said_of_standard(self) -> str:
        """How far off Standard is where that is more than the formula; "" where it is not."""
        new, old = self.standard["exact"], self.standard["blender-4.5"]
        if max(new, old) < self.mean + SEEN:
            return ""
        return (f"In Standard it is {new:.2f}" + (f", in Blender 4.5 {old:.2f}" if abs(new - old) > SEEN else "")
                + "; Reference is the formula itself.")

    def to_dict(self) -> dict[str, Any]:
        """The same as dicts, lists, numbers and texts, ready for JSON; without the images."""
        return {
            "file": self.file, "title": self.title, "format": self.form, "model": self.model, "fresnel": self.fresnel,
            "parameters": self.parameters.to_dict(), "light": HELD_OUT,
            "delta_e_2000": {"mean": self.mean, "p95": self.p95},
            "standard": dict(self.standard), "worst": {"view_degrees": self.worst_degrees, "delta_e_2000": self.worst},
            "samples": {"used": self.used, "rejected": self.rejected}, "verdict": self.verdict,
            "tried": dict(self.tried), "notes": list(self.notes)}

    def record(self, realisation="usual", renderer=ANY_RENDERER):
        """The :class:`addon.models.record.Record` of its material, which says what it was fitted from."""
        record = made(preset=self.preset(), realisation=realisation, renderer=renderer)
        return record.changed(baked={**record.baked, "fitted": self.to_dict()})

    def preset(self) -> Preset:
        """The Preset that it is: what :func:`addon.api.create_material` takes."""
        said = {row.name: getattr(self.parameters, row.name) for row in self.parameters.TABLE if row.is_value}
        for name in list(said):
            rest = {other: value for other, value in said.items() if other != name}
            if type(self.parameters)(**rest) == self.parameters:  # a default, or what another one says as well
                said = rest
        return Preset(name=self.file, title=self.title, kind="surface", model=self.model, note=self.said(),
                      parameters=said)


def report_of(measurement, form, p, brdf, ball, tried):
    """The Fit of a Form's numbers, held against a BRDF on a ball under the surrounding that was not fitted to."""
    parameters = form.final(p)
    measured, fitted = ball.of_brdf(brdf), form.model.evaluate(parameters, UP, ball.v, ball.l)
    difference = ball.differences(measured, fitted, HELD_OUT)
    images = [ball.image(HELD_OUT, f) for f in (measured, fitted)]
    exposure = exposure_of(ball, images[0])
    exposed = tuple(image * exposure for image in images)
    by_ring = difference.mean(axis=1)
    worst = int(np.argmax(by_ring))
    mean = _kept(ball.mean(difference))
    reason = REASONS[_cause(ball, difference, exposed)] if mean > POOR else ""
    return Fit(
        measurement.name, measurement.title, measurement.form, form.model.name, form.name, parameters, mean,
        _kept(below(difference, ball.area)), _kept(np.degrees(ball.theta[worst])), _kept(by_ring[worst]),
        {formula: _kept(ball.mean(ball.differences(measured, form.standard(parameters, ball.v, ball.l, formula),
                                                   HELD_OUT))) for formula in FORMULAS},
        len(measurement.samples.v), measurement.rejected, reason, {name: _kept(x) for name, x in tried.items()},
        measurement.notes, exposed)


def _kept(x):
    """Four decimals: the last bits hang on the machine."""
    return round(float(x), 4)


def _cause(ball, difference, exposed):
    """The key of REASONS that most of the squared difference goes by: first colour or lightness, then where."""
    first, second = (lab(displayed(image, 1.0)) for image in exposed)
    weight = ball.area * difference**2
    change = first - second
    lightness = np.sum(ball.area * change[..., 0] ** 2)
    if np.sum(ball.area * np.sum(change[..., 1:] ** 2, axis=-1)) > 2.0 * lightness:
        return "colour"
    grazing = np.broadcast_to(ball.theta[:, None] > GRAZING, weight.shape)
    highlight = ~grazing & (np.max(exposed[0], axis=-1) > BRIGHT)
    shares = {"grazing": weight[grazing].sum(), "highlight": weight[highlight].sum(),
              "body": weight[~grazing & ~highlight].sum()}
    return max(shares, key=shares.get)
