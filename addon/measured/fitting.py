"""The fit of a model to a measured BRDF: a search over samples, then one over the colours of a displayed ball.

A generator does it step by step, so that whoever waits can show how far it is
and stop it.  The same file gives the same numbers.
"""

import numpy as np

from ..errors import FacetFilmError, choice
from .ball import ball
from .between import Between
from .fit import report_of
from .forms import form_names, form_of
from .least_squares import least_squares
from .problems import ImageProblem, SampleProblem, guess_of
from .reading import read_brdf

__all__ = ["BEST", "fit", "fit_steps"]

BEST = "best"
STOPPED = "The fit was stopped."
FITTED_BALL, SHOWN_BALL = (12, 24, 32, 24), (20, 48, 48, 48)
SAMPLE_ROUNDS, STRAIGHT_ROUNDS, IMAGE_ROUNDS = 60, 10, 16
LEAST_GAIN = 3e-5
STIFFNESS = 1.0
"""What bends of 1 in a curve count, in what cannot be fitted."""
EXACT = 1e-9
"""Share of all that samples hold that a search leaves of them where they are the model's own."""
WORTH_IT = 0.95
"""A form with more numbers is taken where it leaves less than this of the colour difference that is shown."""
LEAST_PEAK = 0.05
"""Of the other's peak of D; below, a highlight is gone."""
NEWEST = "exact"
"""The conductor Fresnel of the renderer that it is shown by."""


def fit(measured, *, progress=None, **options):
    """The :class:`addon.measured.fit.Fit` of a measured BRDF.

    measured  path of a file, or a Measurement
    progress  function that is told the share that is done, 0 to 1; where it gives False the fit stops
    options   of :func:`fit_steps`: fresnel, slopes, distribution

    Raises FacetFilmError for a file that cannot be used, an unknown option, and where it was stopped.
    """
    steps = fit_steps(measured, **options)
    try:
        while True:
            share = next(steps)
            if progress is not None and progress(share) is False:
                steps.close()
                raise FacetFilmError(STOPPED)
    except StopIteration as end:
        return end.value


def fit_steps(measured, *, fresnel=BEST, slopes=2, distribution="beckmann"):
    """A generator of the share that is done, which returns the Fit.

    fresnel       "f0", "n_k", "curve", or "best": the simplest of which no other is clearly better
    slopes        1 to 3; a curve has at most two
    distribution  "beckmann" or "gaussian"; a curve has Beckmann's
    """
    choice("fresnel", fresnel, (BEST, *form_names()))
    names = form_names() if fresnel == BEST else [fresnel]
    forms = [form_of(name, slopes, distribution) for name in names]
    measurement = measured if hasattr(measured, "samples") else read_brdf(measured)
    best, tried = None, {}
    for i, form in enumerate(forms):
        found = yield from _within(_fitted(form, measurement, best), i / len(forms), 1.0 / len(forms))
        tried[names[i]] = found.difference
        if best is None or found.is_clearly_closer(best):
            best = found
    return report_of(measurement, best.form, best.p, best.brdf, ball(*SHOWN_BALL), tried)


class _Searched:
    """A form, its numbers, the BRDF that it is held against, and the mean colour difference from that: its own, and
    what is shown where that is more, by Standard.
    """

    def __init__(self, form, p, brdf, image):
        self.form, self.p, self.brdf = form, p, brdf
        self.difference = image.difference(form.evaluate(p, image.v, image.l))
        standard = form.standard(form.checked(p), image.v, image.l, NEWEST)
        self.shown = max(self.difference, image.difference(standard))

    def is_clearly_closer(self, other):
        """Than one with fewer numbers, and not at the price of the gloss, which is little of a picture."""
        keeps_gloss = self.form.peak(self.p) > LEAST_PEAK * other.form.peak(other.p)
        return keeps_gloss and self.shown < WORTH_IT * other.shown


def _within(steps, start, part):
    """The steps, whose shares are of a part of the whole; what they return."""
    try:
        while True:
            yield start + part * next(steps)
    except StopIteration as end:
        return end.value


def _fitted(form, measurement, other):
    """Steps that return the _Searched of one form; `other` is one that was fitted before, to start from as well."""
    like_other = [form.from_other(other.form, other.p)] if other is not None else []
    like_other = [p for p in like_other if p is not None]
    starts = [*form.starts(guess_of(measurement.samples)), *like_other]
    problem, best, whole = SampleProblem(form, measurement.samples), None, len(starts) + 2
    for i, start in enumerate(starts):
        found = yield from _counted(problem, start, SAMPLE_ROUNDS, i / whole, 1.0 / whole)
        if best is None or found.cost < best.cost:
            best = found
    best = yield from _straightened(problem, best, STRAIGHT_ROUNDS, 1.0 - 2.0 / whole, 1.0 / whole)
    shown = ball(*FITTED_BALL)
    p, brdf = best.parameters, measurement.brdf
    if brdf is None:  # points alone: between them there is what the fit says, and how far the nearest are from it
        brdf = Between(measurement.samples, lambda v, l: form.evaluate(p, v, l)).brdf
    image = ImageProblem(form, shown, shown.of_brdf(brdf))
    if measurement.brdf is not None and best.cost > EXACT * problem.whole:
        begin = min([p, *like_other], key=lambda p: np.sum(image.residuals(p) ** 2))
        found = yield from _counted(image, begin, IMAGE_ROUNDS, 1.0 - 1.0 / whole, 0.5 / whole)
        found = yield from _straightened(image, found, IMAGE_ROUNDS, 1.0 - 0.5 / whole, 0.5 / whole)
        p = found.parameters
    return _Searched(form, p, brdf, image)


def _straightened(problem, found, rounds, first, part):
    """The steps of a search again in which a curve's bends count as much as what cannot be fitted; nothing for others.

    A file that is fitted exactly keeps its bends.
    """
    if not problem.form.bends(found.parameters).size:
        return found
    problem.stiffness = STIFFNESS * found.cost ** 0.5
    return (yield from _counted(problem, found.parameters, rounds, first, part))


def _counted(problem, start, rounds, first, part):
    """The steps of a search, with the share that is done."""
    search, done = least_squares(problem, start, rounds=rounds, least_gain=LEAST_GAIN), 0
    try:
        while True:
            yield first + part * done / rounds
            next(search)
            done += 1
    except StopIteration as end:
        return end.value
