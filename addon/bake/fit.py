"""Finds the two numbers a channel whose Fresnel curve looks most like a given one."""

import numpy as np

from .colour import delta_e_2000, lab

__all__ = ["fit", "family_of", "linear_family_of", "largest_delta_e", "colour_metric"]

STEP = 1e-4
ROUNDS, PATIENCE = 16, 4
"""Of how many rounds the search is at most, and how many that better nothing it bears."""
GOOD_ENOUGH = 0.02
"""CIEDE2000 that no eye sees: there the search ends."""


def fit(family, target, start, low, high, metric):
    """The parameters ``(2, 3)`` of a family of curves that come closest to the target.

    family     p ``(2, 3)`` to the curve ``(A, 3)`` and its slopes ``(A, 3, 2)``
    target     linear RGB over angle, ``(A, 3)``
    start      two parameters a channel, ``(2, 3)``
    low, high  the bounds of each parameter, ``(2,)``
    metric     what a difference counts at each angle: colour_metric(target)

    Levenberg and Marquardt's method on all channels at once.  Angles where the
    fit is worse than on average gain weight from round to round (Lawson's
    method), so that it is the largest difference that becomes small.
    """
    root = np.linalg.cholesky(metric)  # error·metric·error is the sum of squares of error·root
    spread = np.swapaxes(root, 1, 2)[..., None]
    low, high = np.array(low)[:, None], np.array(high)[:, None]
    weights = np.full(len(target), 1.0 / len(target))
    parameters = trial = best = np.clip(start, low, high)
    damping, mean, best_worst, idle = 1e-3, np.inf, np.inf, 0
    for _ in range(ROUNDS):
        curve, slopes = family(trial)
        error = ((target - curve)[:, None, :] @ root)[:, 0, :]
        squares = (error * error).sum(axis=1)
        worst = squares.max()
        accepted = weights @ squares <= mean
        idle = 0 if worst < 0.9 * best_worst else idle + accepted
        if worst < best_worst:
            best, best_worst = trial, worst
        if worst < GOOD_ENOUGH**2 or idle == PATIENCE:
            break
        if accepted:
            damping *= 0.1
            parameters = trial
            weights = weights * np.sqrt(squares)
            weights /= weights.sum()
            mean = weights @ squares
            jacobian = (spread * slopes[:, None]).reshape(-1, 6)
            weighted = (jacobian * np.repeat(weights, 3)[:, None]).T
            gradient, hessian = weighted @ error.ravel(), weighted @ jacobian
            at_low, at_high = (parameters <= low).T.ravel(), (parameters >= high).T.ravel()
            # The others push against a bound.
            moves = ~(at_low & (gradient < 0.0) | at_high & (gradient > 0.0))
        else:
            damping *= 10.0
        trial = np.clip(parameters + _step(gradient, hessian, damping, moves), low, high)
    return best


def _step(gradient, hessian, damping, moves):
    """The damped Gauss-Newton step ``(2, 3)`` of the parameters that move."""
    matrix = hessian * (moves[:, None] & moves)
    matrix.flat[::7] = matrix.flat[::7] * (1.0 + damping) + np.where(moves, 1e-12, 1.0)
    return np.linalg.solve(matrix, gradient * moves).reshape(3, 2).T


def family_of(formula, cos_theta):
    """The curves of a formula f(cos_theta, p, q) over its two parameters, for :func:`fit`.

    cos_theta  ``(A,)``
    """
    c = cos_theta[:, None]
    moved = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])[:, :, None, None] * STEP  # p or q, one at a time

    def family(parameters):
        p, q = parameters[:, None, None, :] + moved
        curves = formula(c, p, q)
        return curves[0], (curves[1:] - curves[0]).transpose(1, 2, 0) / STEP
    return family


def linear_family_of(formula, cos_theta):
    """The same of a formula that is linear in its parameters: its slopes are calculated once.

    cos_theta  ``(A,)``
    """
    origin, *ends = formula(cos_theta, np.array([[0.0], [1.0], [0.0]]), np.array([[0.0], [0.0], [1.0]]))
    slopes = np.stack([end - origin for end in ends], axis=-1)[:, None, :]

    def family(parameters):
        return origin[:, None] + (slopes[:, 0] @ parameters), slopes
    return family


def largest_delta_e(rgb, target_lab, space="Rec.709"):
    """The largest CIEDE2000 between linear RGB ``(A, 3)`` and L*a*b* ``(A, 3)``.

    >>> float(largest_delta_e(np.full((2, 3), 0.5), lab(np.full((2, 3), 0.5))))
    0.0
    """
    return float(delta_e_2000(target_lab, lab(rgb, space)).max())


def colour_metric(rgb, rgb_lab, space="Rec.709"):
    """``(A, 3, 3)``: the quadratic form in changes of linear RGB that CIEDE2000² is near each colour.

    rgb, rgb_lab  the colours in linear RGB and in L*a*b*, ``(A, 3)`` each

    From differences along each channel, and along pairs of them by polarisation.
    """
    pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
    eye = np.eye(3)
    changes = 1e-5 * np.array([eye[i] if i == j else eye[i] + eye[j] for i, j in pairs])
    squares = (delta_e_2000(rgb_lab, lab(rgb + changes[:, None], space)) / 1e-5) ** 2
    metric = np.empty((len(rgb), 3, 3))
    for (i, j), square in zip(pairs, squares):
        metric[:, i, j] = metric[:, j, i] = square if i == j else 0.5 * (square - squares[i] - squares[j])
    return metric
