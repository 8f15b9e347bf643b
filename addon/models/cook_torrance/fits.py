"""Cook and Torrance's model fitted to measured BRDFs: F of its reflectance at normal incidence, or of n and k."""

import numpy as np

from ...reflectance.fresnel import conductor_from_normal, index_from_normal
from ..fitted import UP, Form
from ..model import Renderer
from .baking import native_fresnel
from .formulas import evaluate

__all__ = ["IndexAndExtinction", "NormalReflectance"]


class _OnFacets(Form):
    """With the slopes and the distribution of the model."""

    def facets(self, slopes, kept):
        """As they are."""
        return {"slopes": slopes, "distribution": self.distribution}

    def standard(self, parameters, v, l, formula):
        """With the F that the renderer's closures evaluate; the shadowing of facets is next to the formula's."""
        _, fresnel = native_fresnel(np.array(parameters.n), np.array(parameters.k), Renderer(formula))
        return evaluate(parameters, UP, v, l, fresnel=fresnel)


class NormalReflectance(_OnFacets):
    """F of a dielectric, by its reflectance at normal incidence: k = 0."""

    name = "f0"
    low_f, high_f = (1e-4,), (0.96,)
    tried = 4

    def fresnel(self, rows, kept):
        """n of F0."""
        return {"n": tuple(map(kept, index_from_normal(rows[0]))), "k": (0.0, 0.0, 0.0)}

    def rows_of(self, f0):
        """Itself."""
        return f0[None]

    def reflectance_of(self, rows):
        """Itself."""
        return rows[0]


class IndexAndExtinction(_OnFacets):
    """F of n and k, searched by F0 and by how soon F rises: no body is thinner than air, n² + k² ≥ 1.

    Thinner ones, which reflect all of the light from some angle on, may be closer to felt; but no measured material is
    one, and Blender 4.5's conductor misses them by far.
    """

    name = "n_k"
    low_f, high_f = (1e-4, 0.0), (0.96, 1.0)

    def fresnel(self, rows, kept):
        """n and k."""
        n, k = conductor_from_normal(*rows)
        return {"n": tuple(map(kept, n)), "k": tuple(map(kept, k))}

    def rows_of(self, f0):
        """A dielectric with a little k, or from F0 = 0.3 on a metal."""
        return np.stack([f0, np.where(f0 > 0.3, 0.8, 0.3)])

    def reflectance_of(self, rows):
        """The first."""
        return rows[0]
