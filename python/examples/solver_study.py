#!/usr/bin/env python3
"""A solver study: scipy's L-BFGS-B beside our own solvers, on one level of one pair, from the same start.

Evaluations with gradient are what counts here, as all methods call the same function. A method has reached the minimum
where its energy is within a thousandth of the lowest that any of them finds. Needs scipy. Run it as it is, or with a pair and a level of your own:

    python3 solver_study.py [REFERENCE TEMPLATE LEVEL]
"""

import sys
import time

import numpy as np
import scipy.optimize

import shellmatch

reference, template, level = sys.argv[1:4] if len(sys.argv) > 3 else ("generate:hand", "generate:hand/bent", "4")

# The energy on this level, where the cascade begins it.
problem = shellmatch.Problem(reference, template, levels=(3, int(level)), align="none", start="coarser")
objective = problem.objective()  # a finite wall in place of inf, which L-BFGS-B takes for convergence
print(
    f"level {problem.level}: {problem.sizes[problem.level]['cells']} cells, {problem.size} unknowns, E(x0) = {problem.energy(problem.x0):.5g}"
)

runs = {}  # name -> (energies after each evaluation with gradient, seconds)


def with_scipy(name, scale):
    """In y = scale x: with the root of the lumped mass the gradient is that of L2."""
    energies = []

    def value(y):
        energy, gradient = objective(y / scale)
        energies.append(energy)
        return energy, gradient / scale

    begin = time.perf_counter()
    scipy.optimize.minimize(
        value,
        problem.x0 * scale,
        jac=True,
        method="L-BFGS-B",
        options={"maxcor": 12, "maxiter": 20000, "maxfun": 20000, "ftol": 1e-9, "gtol": 0},
    )
    runs[name] = (energies, time.perf_counter() - begin)


def with_ours(label, **solver):
    found = problem.minimize(stop={"max_iterations": 20000, "relative_decrease": 1e-8}, **solver)
    energies = np.full(found.gradient_evaluations + 1, np.inf)
    for row in found.history:
        energies[row["gradient_evaluations"]] = row["energy"]
    runs[label] = (energies[1:], found.seconds)


with_scipy("scipy L-BFGS-B", np.ones(problem.size))
with_scipy("scipy L-BFGS-B in L2", np.sqrt(problem.mass))
with_ours("our lbfgs", name="lbfgs", metric="euclidean")
with_ours("our lbfgs in L2", name="lbfgs", metric="l2")
with_ours("our lbfgs in h1_band", name="lbfgs", metric="h1_band")
with_ours("our newton", name="newton")

best = min(np.min(energies) for energies, _ in runs.values())
print(f"{'method':24} {'lowest energy':>14} {'gap':>9} {'gradients':>10} {'to 1e-3':>8} {'seconds':>8}")
for name, (energies, seconds) in runs.items():
    reached = np.flatnonzero(np.minimum.accumulate(energies) <= best * 1.001)
    print(
        f"{name:24} {np.min(energies):14.8g} {np.min(energies) / best - 1:9.1e} {len(energies):10} {reached[0] + 1 if len(reached) else '-':>8} {seconds:8.2f}"
    )
