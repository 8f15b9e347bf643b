"""Finds the two numbers a channel whose Fresnel curve looks most like a given one."""

import numpy as np

from .colour import delta_e_2000, lab

__all__ = ["fit", "largest_delta_e", "colour_metric"]

STEP = 1e-5
ROUNDS = 30


def fit(formula, cos_theta, target, start, low, high, space="Rec.709"):
    """(parameters ``(2, 3)``, largest CIEDE2000) of the formula that comes closest to the target.

    formula    f(cos_theta, p, q): reflectance, element by element
    cos_theta  ``(A,)``
    target     linear RGB over angle, ``(A, 3)``
    start      two parameters a channel, ``(2, 3)``
    low, high  the bounds of each parameter, ``(2,)``

    Levenberg and Marquardt's method on all channels at once.  Errors are
    measured by the metric that CIEDE2000 has at the target's colours; angles
    where the fit is worst gain weight from round to round (Lawson's method),
    so that it is the largest difference that becomes small.
    """
    metric = colour_metric(target, space)
    low, high = np.asarray(low, float)[:, None], np.asarray(high, float)[:, None]
    c = cos_theta[:, None]
    parameters = np.clip(start, low, high)
    weights = np.full(len(c), 1.0 / len(c))
    damping = 1e-3
    best, best_size = parameters, np.inf
    error = target - formula(c, *parameters)
    squares = _squares(metric, error)
    for _ in range(ROUNDS):
        if squares.max() < best_size:
            best, best_size = parameters, squares.max()
        step, slope = _step(formula, c, parameters, error, metric, weights, damping, low, high)
        trial = np.clip(parameters + step, low, high)
        trial_error = target - formula(c, *trial)
        trial_squares = _squares(metric, trial_error)
        if weights @ trial_squares <= weights @ squares:
            settled = weights @ (squares - trial_squares) < 1e-3 * (weights @ squares)
            parameters, error, squares = trial, trial_error, trial_squares
            damping = max(damping * 0.2, 1e-9)
            if settled:
                weights = _reweighted(weights, squares)
        else:
            damping *= 8.0
            if damping > 1e6:
                break
    if squares.max() < best_size:
        best = parameters
    return best, largest_delta_e(formula(c, *best), target, space)


def largest_delta_e(rgb, target, space="Rec.709"):
    """The largest CIEDE2000 between colours ``(A, 3)`` and ``(A, 3)``.

    >>> float(largest_delta_e(np.full((2, 3), 0.5), np.full((2, 3), 0.5)))
    0.0
    """
    return float(delta_e_2000(lab(target, space), lab(rgb, space)).max())


def colour_metric(rgb, space="Rec.709"):
    """``(A, 3, 3)``: the quadratic form in changes of linear RGB that CIEDE2000² is near each colour.

    From differences along each channel, and along pairs of them by polarisation.
    """
    pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
    eye = np.eye(3)
    changes = STEP * np.array([eye[i] if i == j else eye[i] + eye[j] for i, j in pairs])
    squares = (delta_e_2000(lab(rgb, space), lab(rgb + changes[:, None], space)) / STEP) ** 2
    metric = np.empty((len(rgb), 3, 3))
    for (i, j), square in zip(pairs, squares):
        off = square if i == j else 0.5 * (square - squares[i] - squares[j])
        metric[:, i, j] = metric[:, j, i] = off
    return metric


def _squares(metric, error):
    return np.einsum("ac,acd,ad->a", error, metric, error)


def _step(formula, c, parameters, error, metric, weights, damping, low, high):
    """The damped Gauss-Newton step ``(2, 3)``; parameters that push against a bound rest."""
    h = STEP * np.maximum(np.abs(parameters), 1e-2)
    h = np.where(parameters + h > high, -h, h)
    fitted = formula(c, *parameters)
    slopes = np.stack([(formula(c, parameters[0] + h[0], parameters[1]) - fitted) / h[0],
                       (formula(c, parameters[0], parameters[1] + h[1]) - fitted) / h[1]], axis=1)  # a, p, c
    weighted = metric * weights[:, None, None]
    gradient = np.einsum("apc,acd,ad->pc", slopes, weighted, error).ravel()
    hessian = np.einsum("apc,acd,aqd->pcqd", slopes, weighted, slopes).reshape(6, 6)
    at_bound = ((parameters <= low).ravel() & (gradient < 0.0)) | ((parameters >= high).ravel() & (gradient > 0.0))
    gradient = np.where(at_bound, 0.0, gradient)
    free = ~at_bound
    hessian = hessian * (free[:, None] & free[None, :])
    diagonal = np.maximum(np.diag(hessian), 1e-12)
    step = np.linalg.solve(hessian + np.diag(damping * diagonal + at_bound), gradient)
    return step.reshape(2, 3), slopes


def _reweighted(weights, squares):
    grown = weights * np.sqrt(np.maximum(squares, 1e-12))
    return grown / grown.sum()
