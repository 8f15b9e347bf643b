"""Levenberg and Marquardt's method within bounds, a step at a time.

D. W. Marquardt, "An Algorithm for Least-Squares Estimation of Nonlinear
Parameters", SIAM Journal 11(2), 1963; parameters that push against a bound
rest.
"""

from typing import NamedTuple

import numpy as np

__all__ = ["Found", "least_squares"]

STEP = 1e-4
WIDEST = 2.0
"""What a step may move a parameter by at most."""
TRIES = 8


class Found(NamedTuple):
    """Parameters ``(P,)`` and the sum of squares that they leave."""

    parameters: np.ndarray
    cost: float


def least_squares(problem, start, *, rounds=60, least_gain=1e-4):
    """A generator of a step each, which returns the Found.

    problem     low and high, bounds ``(P,)``; residuals(p) -> ``(R,)``; jacobian(p, residuals at p, steps) ->
                ``(R, P)``
    start       ``(P,)``
    least_gain  share of the cost that a step has to save for another to follow
    """
    low, high = problem.low, problem.high
    p = np.clip(start, low, high)
    r = problem.residuals(p)
    cost, damping, span = r @ r, 1e-2, np.minimum(high - low, WIDEST)
    for _ in range(rounds):
        steps = STEP * span
        jacobian = problem.jacobian(p, np.where(p + steps > high, -steps, steps))
        gradient, hessian = jacobian.T @ r, jacobian.T @ jacobian
        free = ~((p <= low) & (gradient > 0.0) | (p >= high) & (gradient < 0.0))
        gained = 0.0
        for _ in range(TRIES):
            trial = np.clip(p + np.clip(_step(hessian, gradient, free, damping), -span, span), low, high)
            r_trial = problem.residuals(trial)
            trial_cost = r_trial @ r_trial
            if trial_cost < cost:
                gained = (cost - trial_cost) / cost
                p, r, cost, damping = trial, r_trial, trial_cost, max(damping / 5.0, 1e-7)
                break
            damping *= 4.0
        yield
        if gained < least_gain:
            break
    return Found(p, float(cost))


def _step(hessian, gradient, free, damping):
    matrix = hessian * (free[:, None] & free)
    matrix.flat[::len(free) + 1] = matrix.diagonal() * (1.0 + damping) + np.where(free, 1e-12, 1.0)
    return np.linalg.solve(matrix, -gradient * free)
