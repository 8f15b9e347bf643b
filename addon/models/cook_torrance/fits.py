"""Cook and Torrance's model fitted to measured BRDFs: F of its reflectance at normal incidence, or of n and k."""

import numpy as np

from ..fitted import Form

__all__ = ["IndexAndExtinction", "NormalReflectance"]


class _OnFacets(Form):
    """With the slopes and the distribution of the model."""

    def facets(self, slopes, kept):
        """As they are."""
        return {"slopes": slopes, "distribution": self.distribution}


class NormalReflectance(_OnFacets):
    """F of a dielectric, by its reflectance at normal incidence: k = 0."""

    name = "f0"
    low_f, high_f = (1e-4,), (0.96,)
    tried = 4

    def fresnel(self, rows, kept):
        """n of F0."""
        root = np.sqrt(rows[0])
        return {"n": tuple(map(kept, (1.0 + root) / (1.0 - root))), "k": (0.0, 0.0, 0.0)}

    def rows_of(self, f0):
        """Itself."""
        return f0[None]

    def reflectance_of(self, rows):
        """Itself."""
        return rows[0]


class IndexAndExtinction(_OnFacets):
    """F of n and k."""

    name = "n_k"
    low_f, high_f = (0.05, 0.0), (5.0, 8.0)

    def fresnel(self, rows, kept):
        """n and k."""
        return {"n": tuple(map(kept, rows[0])), "k": tuple(map(kept, rows[1]))}

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
