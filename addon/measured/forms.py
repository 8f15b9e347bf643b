"""What is fitted: how the numbers that a search moves become the parameters of a model.

All of them: a diffuse colour, F, the share s, and slopes with their shares.
The share of the diffuse part is 1 − s and that of the slopes sums to 1, so
that s + d ≤ 1 and Σw ≤ 1 hold whatever the search does.
"""

import numpy as np

from ..errors import choice, number
from ..models import named

__all__ = ["FORMS", "Curve", "Form", "IndexAndExtinction", "NormalReflectance", "form_of"]

SMOOTHEST, ROUGHEST = 0.004, 1.0
LEAST_SHARE, MOST_SHARE = 1e-3, 0.9995
MOST_LOGIT = 7.0
UP = np.array([0.0, 0.0, 1.0])
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
DEGREES = (0.0, 15.0, 30.0, 45.0, 60.0, 72.0, 83.0, 90.0)
"""Where a curve has its knots: angles between light and facet."""

BEND_WEIGHTS = np.array([1.0, 1.0, 1.0, 1.0, 0.3, 0.1])[:, None]


class Form:
    """A surface under fit.  The numbers: diffuse (3), F (3 a row), ln s, ln m, then of each further slope ln m, ln of
    its share over the first's.

    slopes        how many, 1 to 3
    distribution  "beckmann" or "gaussian"
    low, high     bounds of the numbers, ``(P,)``
    groups        the numbers that change f independently of each other: of a colour, each its channel
    """

    name = ""
    model = "cook_torrance"
    low_f: tuple = ()
    high_f: tuple = ()

    def __init__(self, slopes, distribution):
        self.slopes, self.distribution = slopes, distribution
        self.rows = len(self.low_f)
        more = slopes - 1
        self.low = np.r_[np.zeros(3), np.repeat(self.low_f, 3), np.log(LEAST_SHARE), np.log(SMOOTHEST),
                         [np.log(SMOOTHEST), -MOST_LOGIT] * more]
        self.high = np.r_[np.ones(3), np.repeat(self.high_f, 3), np.log(MOST_SHARE), np.log(ROUGHEST),
                          [np.log(ROUGHEST), MOST_LOGIT] * more]
        colours = [range(3 * row, 3 * row + 3) for row in range(1 + self.rows)]
        self.groups = [*map(tuple, colours), *((i,) for i in range(3 * (1 + self.rows), len(self.low)))]

    def parameters(self, p):
        """{name: value} of the model's."""
        f, (share, *pairs) = p[3:3 + 3 * self.rows].reshape(-1, 3), p[3 + 3 * self.rows:]
        m = np.exp([pairs[0], *pairs[1::2]])
        w = np.exp([0.0, *pairs[2::2]])
        slopes = tuple(sorted(zip(m.tolist(), (w / w.sum()).tolist())))
        return {"diffuse": tuple(p[:3].tolist()), "specular": float(np.exp(share)), **self.fresnel(f),
                **self.facets(slopes)}

    def facets(self, slopes):
        """{name: value} of (m, w) pairs."""
        return {"slopes": slopes, "distribution": self.distribution}

    def fresnel(self, rows):
        """{name: value} of F's numbers, ``(rows, 3)``."""
        raise NotImplementedError

    def rows_of(self, f0):
        """F's numbers ``(rows, 3)`` where all that is known is the normal reflectance ``(3,)``."""
        raise NotImplementedError

    def bends(self, p):
        """How much F's numbers wind, ``(B,)``; none but a curve's do."""
        return np.zeros(0)

    def checked(self, p):
        """The model's checked parameters."""
        return named(self.model).parameters(**self.parameters(p))

    def evaluate(self, p, v, l):
        """Model.evaluate of the numbers, ``(N, 3)``."""
        return named(self.model).evaluate(self.checked(p), UP, v, l)

    def starts(self, guess):
        """The numbers to start from, of a Guess."""
        found = []
        for share in guess.shares:
            rows = self.rows_of(np.clip(guess.top / share, 2e-4, 0.95))
            for narrow in (1.0, 0.6 if self.slopes == 1 else 0.5):
                m = np.clip(guess.m * narrow * np.array({1: (1.0,), 2: (0.9, 3.0), 3: (0.7, 1.6, 4.0)}[self.slopes]),
                            SMOOTHEST, 0.9)
                more = [x for further in m[1:] for x in (np.log(further), -1.0)]
                p = np.r_[guess.diffuse / (1.0 - share), rows.ravel(), np.log(share), np.log(m[0]), more]
                found.append(np.clip(p, self.low, self.high))
        return found

    def from_other(self, form, p):
        """The numbers that come closest to those of another form with as many slopes."""
        f0 = form.normal_reflectance(p)
        return np.clip(np.r_[p[:3], self.rows_of(f0).ravel(), p[3 + 3 * form.rows:]], self.low, self.high)

    def normal_reflectance(self, p):
        """F at normal incidence, ``(3,)``."""
        return self.reflectance_of(p[3:3 + 3 * self.rows].reshape(-1, 3))


class NormalReflectance(Form):
    """F of a dielectric, by its reflectance at normal incidence: k = 0."""

    name = "f0"
    low_f, high_f = (1e-4,), (0.96,)

    def fresnel(self, rows):
        """n of F0."""
        root = np.sqrt(rows[0])
        return {"n": tuple(((1.0 + root) / (1.0 - root)).tolist()), "k": (0.0, 0.0, 0.0)}

    def rows_of(self, f0):
        """Itself."""
        return f0[None]

    def reflectance_of(self, rows):
        """Itself."""
        return rows[0]


class IndexAndExtinction(Form):
    """F of n and k."""

    name = "n_k"
    low_f, high_f = (0.05, 0.0), (5.0, 8.0)

    def fresnel(self, rows):
        """n and k."""
        return {"n": tuple(rows[0].tolist()), "k": tuple(rows[1].tolist())}

    def rows_of(self, f0):
        """A dielectric with a little k, or from F0 = 0.3 on a metal with n = 0.5."""
        root, metal = np.sqrt(f0), f0 > 0.3
        n = np.where(metal, 0.5, np.clip((1.0 + root) / (1.0 - root), 0.3, 4.5))
        k = np.where(metal, np.sqrt(np.clip((2.25 * f0 - 0.25) / (1.0 - f0), 0.01, 40.0)), 0.05)
        return np.stack([n, np.minimum(k, 7.0)])

    def reflectance_of(self, rows):
        """((n − 1)² + k²)/((n + 1)² + k²)."""
        n, k = rows
        return ((n - 1.0) ** 2 + k * k) / ((n + 1.0) ** 2 + k * k)


class Curve(Form):
    """F free over the angle, between knots: the film model's table."""

    model = "film"
    name = "curve"
    low_f, high_f = (0.0,) * len(DEGREES), (1.0,) * len(DEGREES)

    def facets(self, slopes):
        """Its roughness; a curve has no thickness."""
        return {"roughness": slopes[0][0] ** 0.5, "thickness": 0.0}

    def fresnel(self, rows):
        """The curve in words."""
        from ..bake.film_curve import curve_in_words
        return {"stack": curve_in_words(DEGREES, rows)}

    def bends(self, p):
        """Second differences of the knots, less of those at grazing, where every curve bends up."""
        rows = p[3:3 + 3 * self.rows].reshape(-1, 3)
        return (np.diff(rows, 2, axis=0) * BEND_WEIGHTS).ravel()

    def rows_of(self, f0):
        """Schlick's curve."""
        cosine = np.cos(np.radians(DEGREES))[:, None]
        return f0 + (1.0 - f0) * (1.0 - cosine) ** 5

    def reflectance_of(self, rows):
        """The first knot."""
        return rows[0]


FORMS = {form.name: form for form in (NormalReflectance, IndexAndExtinction, Curve)}
"""The simplest first."""


def form_of(fresnel, slopes=2, distribution="beckmann"):
    """The Form of a name: "f0", "n_k" or "curve"; FacetFilmError for another, or other slopes or distribution."""
    choice("fresnel", fresnel, FORMS)
    choice("distribution", distribution, ("beckmann", "gaussian"))
    return FORMS[fresnel](int(number("slopes", slopes, 1, 3)), distribution)
