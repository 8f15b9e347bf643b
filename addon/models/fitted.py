"""How a model is fitted to measurements: what the numbers that a search moves become in its parameters.

All forms have a diffuse colour, F, the share s, and slopes with their shares.
The share of the diffuse part is 1 − s and that of the slopes sums to 1, so
that s + d ≤ 1 and Σw ≤ 1 hold whatever the search does.
"""

import numpy as np

__all__ = ["UP", "Form", "Guess"]

SMOOTHEST = 0.004
LEAST_SHARE, MOST_SHARE = 1e-3, 0.9995
MOST_LOGIT = 7.0
UP = np.array([0.0, 0.0, 1.0])
APART = {1: (1.0,), 2: (0.9, 3.0), 3: (0.7, 1.6, 4.0)}
"""Slopes to start from, in the one that is seen first, by how many there are."""
DIGITS = 6
"""What is kept of the numbers in the end: the last bits hang on the machine."""


class Guess:
    """What samples look like at a glance.

    diffuse  π times f away from the highlight, ``(3,)``
    top      s·F0 in a Beckmann lobe of slope m, ``(3,)``
    m        rms slope
    shares   s to start from
    """

    def __init__(self, diffuse, top, m, shares):
        self.diffuse, self.top, self.m, self.shares = diffuse, top, m, shares


class Form:
    """A surface under fit.  The numbers: diffuse (3), F (3 a row), ln s, ln m, then of each further slope ln m, ln of
    its share over the first's.

    model         the Model
    name          what F is called
    slopes        how many
    distribution  "beckmann" or "gaussian"
    low, high     bounds of the numbers, ``(P,)``
    groups        the numbers that change f independently of each other: of a colour, each its channel
    tried         how many starts are
    roughest      the largest slope
    """

    name = ""
    low_f: tuple = ()
    high_f: tuple = ()
    most_slopes = 3
    roughest = 1.0
    tried = 2

    def __init__(self, model, slopes, distribution):
        self.model, self.slopes, self.distribution = model, min(slopes, self.most_slopes), distribution
        self.rows = len(self.low_f)
        more = self.slopes - 1
        self.low = np.r_[np.zeros(3), np.repeat(self.low_f, 3), np.log(LEAST_SHARE), np.log(SMOOTHEST),
                         [np.log(SMOOTHEST), -MOST_LOGIT] * more]
        self.high = np.r_[np.ones(3), np.repeat(self.high_f, 3), np.log(MOST_SHARE), np.log(self.roughest),
                          [np.log(self.roughest), MOST_LOGIT] * more]
        colours = [range(3 * row, 3 * row + 3) for row in range(1 + self.rows)]
        self.groups = [*map(tuple, colours), *((i,) for i in range(3 * (1 + self.rows), len(self.low)))]

    def parameters(self, p, kept=float):
        """{name: value} of the model's.

        kept  function of a number -> what is kept of it
        """
        rows, share, (m, w) = self._rows(p), p[3 + 3 * self.rows], self._slopes(p)
        order = np.argsort(m)
        w = [kept(x) for x in w[order[:-1]]]
        slopes = tuple(zip(map(kept, m[order]), (*w, kept(1.0 - sum(w)))))
        return {"diffuse": tuple(map(kept, p[:3])), "specular": kept(np.exp(share)), **self.fresnel(rows, kept),
                **self.facets(slopes, kept)}

    def facets(self, slopes, kept):
        """{name: value} of (m, w) pairs."""
        raise NotImplementedError

    def fresnel(self, rows, kept):
        """{name: value} of F's numbers, ``(rows, 3)``."""
        raise NotImplementedError

    def rows_of(self, f0):
        """F's numbers ``(rows, 3)`` where all that is known is the normal reflectance ``(3,)``."""
        raise NotImplementedError

    def reflectance_of(self, rows):
        """F at normal incidence, ``(3,)``."""
        raise NotImplementedError

    def bends(self, p):
        """How much F's numbers wind, ``(B,)``; none but a curve's do."""
        return np.zeros(0)

    def checked(self, p, kept=float):
        """The model's checked parameters."""
        return self.model.parameters(**self.parameters(p, kept))

    def final(self, p):
        """The same with six digits of each number."""
        return self.checked(p, lambda x: float(f"{x:.{DIGITS}g}"))

    def evaluate(self, p, v, l):
        """Model.evaluate of the numbers, ``(N, 3)``; the normal is z."""
        return self.model.evaluate(self.checked(p), UP, v, l)

    def standard(self, parameters, v, l, formula):
        """What Standard renders of the model's parameters, ``(N, 3)``.

        formula  the conductor Fresnel of the renderer's closures, a name of addon.bake.baking.FORMULAS
        """
        return self.model.evaluate(parameters, UP, v, l)

    def starts(self, guess):
        """The numbers to start from, of a Guess."""
        found = []
        for share in guess.shares:
            rows = self.rows_of(np.clip(guess.top / share, 2e-4, 0.95))
            for narrow in (1.0, 0.6 if self.slopes == 1 else 0.5):
                m = np.clip(guess.m * narrow * np.array(APART[self.slopes]), SMOOTHEST, 0.9)
                more = [x for further in m[1:] for x in (np.log(further), -1.0)]
                p = np.r_[guess.diffuse / (1.0 - share), rows.ravel(), np.log(share), np.log(m[0]), more]
                found.append(np.clip(p, self.low, self.high))
        return found[:self.tried]

    def from_other(self, form, p):
        """The numbers that come closest to those of another form; None where that has other slopes."""
        if form.slopes != self.slopes:
            return None
        f0 = form.reflectance_of(form._rows(p))
        return np.clip(np.r_[p[:3], self.rows_of(f0).ravel(), p[3 + 3 * form.rows:]], self.low, self.high)

    def peak(self, p):
        """D of all slopes where facets lie flat, Σ w/m²."""
        m, w = self._slopes(p)
        return float(np.sum(w / (m * m)))

    def _slopes(self, p):
        """m and w of each slope, ``(S,)``; Σw = 1."""
        pairs = p[4 + 3 * self.rows:]
        w = np.exp([0.0, *pairs[2::2]])
        return np.exp([pairs[0], *pairs[1::2]]), w / w.sum()

    def _rows(self, p):
        return p[3:3 + 3 * self.rows].reshape(-1, 3)
