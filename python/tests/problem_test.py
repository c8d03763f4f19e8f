"""Problem: energies and gradients as functions, and what scipy makes of them."""

import unittest

import numpy as np
import shapes

import shellmatch

try:
    import scipy.optimize
except ImportError:
    scipy = None


class Energies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.flat = shellmatch.Problem(
            shapes.ellipse(100),
            shapes.ellipse(100, 1.3, 0.7, 0.3),
            levels=(3, 5),
            align="none",
            start="coarser",
            coverage={"levels": 1},
        )
        ball, egg = shapes.sphere(12), shapes.sphere(12, (1.0, 0.8, 1.3))
        chosen = np.arange(0, 260, 20)
        cls.solid = shellmatch.Problem(
            ball, egg, (chosen, egg[0][chosen]), levels=(3, 4), align="none", start="coarser", **{"landmarks.max_distance": 0.3}
        )

    def test_gradient_is_the_derivative(self):
        """By the order of the remainder: E(x + t d) - E(x) - t g.d falls as t^2."""
        for problem in (self.flat, self.solid):
            random = np.random.default_rng(2)
            for _ in range(3):
                d = random.standard_normal(problem.size)
                d /= np.linalg.norm(d)
                value, gradient = problem.energy_and_gradient(problem.x0)
                self.assertEqual(value, problem.energy(problem.x0))
                self.assertTrue(np.array_equal(gradient, problem.gradient(problem.x0)))
                steps = np.array([2e-4, 1e-4, 5e-5])
                slope = gradient @ d
                remainders = [abs(problem.energy(problem.x0 + t * d) - value - t * slope) for t in steps]
                self.assertAlmostEqual(np.polyfit(np.log(steps), np.log(remainders), 1)[0], 2, delta=0.1)
                difference = (problem.energy(problem.x0 + 1e-5 * d) - problem.energy(problem.x0 - 1e-5 * d)) / 2e-5
                self.assertAlmostEqual(difference, slope, delta=1e-5 * np.linalg.norm(gradient))

    def test_every_component(self):
        small = shellmatch.Problem(shapes.ellipse(60), shapes.ellipse(60, 1.2, 0.8), levels=(3, 3), align="none")
        gradient, h = small.gradient(small.x0), 1e-6
        for i in range(0, small.size, 7):
            e = np.zeros(small.size)
            e[i] = h
            difference = (small.energy(small.x0 + e) - small.energy(small.x0 - e)) / (2 * h)
            self.assertAlmostEqual(difference, gradient[i], delta=1e-5 * np.abs(gradient).max())

    def test_terms_add_up(self):
        for problem, own in ((self.flat, "coverage"), (self.solid, "landmarks")):
            terms = problem.terms(problem.x0)
            self.assertGreater(terms[own], 0)
            self.assertGreater(terms["membrane"], 0)
            self.assertAlmostEqual(sum(terms.values()), problem.energy(problem.x0), delta=1e-12 * problem.energy(problem.x0))

    def test_folds_cannot_be_evaluated(self):
        x = self.flat.x0.copy()
        x[::2] *= -1  # a reflection
        value, gradient = self.flat.energy_and_gradient(x)
        self.assertEqual(value, np.inf)
        self.assertEqual(self.flat.energy(x), np.inf)
        self.assertTrue(np.isnan(gradient).all())
        self.assertTrue(all(np.isnan(v) for v in self.flat.terms(x).values()))
        with self.assertRaises(shellmatch.InputError):
            self.flat.hessp(x, x)
        with self.assertRaises(shellmatch.InputError):
            self.flat.minimize(x)

    def test_the_start_is_that_of_the_cascade(self):
        """Its energy is where register() begins the level; the grid is that of register()."""
        pair = ("generate:circle", "generate:ellipse/long")
        result = shellmatch.register(*pair, levels=(3, 5), align="none", cascade={"nu_substeps": 1})
        problem = shellmatch.Problem(*pair, levels=(3, 5), align="none", cascade={"nu_substeps": 1}, start="coarser")
        first = next(row for row in result.history if row["level"] == 5)
        self.assertAlmostEqual(problem.energy(problem.x0), first["energy"], delta=1e-9 * first["energy"])
        for level in result.summary["levels"]:
            sizes = problem.sizes[level["level"]]
            self.assertEqual(
                (sizes["nodes"], sizes["free_nodes"], sizes["cells"]), (level["nodes"], level["free_nodes"], level["cells"])
            )
        minimum = problem.minimize()
        last = result.history[-1]
        self.assertAlmostEqual(minimum.energy, last["energy"], delta=1e-6 * last["energy"])
        self.assertLess(
            np.abs(problem.map(minimum.x).apply(result.vertices * 0 + 0.5) - result.apply(result.vertices * 0 + 0.5)).max(), 1e-4
        )

    def test_identity(self):
        problem = shellmatch.Problem("generate:circle", "generate:ellipse/long", levels=(3, 4), align="none")
        points = np.random.default_rng(0).random((20, 2))
        self.assertLess(np.abs(problem.map(problem.x0).apply(points) - points).max(), 1e-14)
        self.assertEqual(problem.level, 4)
        self.assertEqual(
            shellmatch.Problem("generate:circle", "generate:ellipse/long", levels=(3, 5), level=3, align="none").sizes.keys(), {3}
        )

    def test_model_of_the_second_derivative(self):
        random = np.random.default_rng(4)
        u, v = random.standard_normal((2, self.flat.size))
        hu, hv = self.flat.hessp(self.flat.x0, u), self.flat.hessp(self.flat.x0, v)
        self.assertAlmostEqual(u @ hv, v @ hu, delta=1e-6 * np.linalg.norm(hu) * np.linalg.norm(v))
        self.assertGreater(u @ hu, 0)
        self.assertTrue(np.array_equal(hu, self.flat.hessp(self.flat.x0.copy(), u)))

    def test_mass(self):
        """Of all free nodes together: the area of the domain, once for each component."""
        problem = shellmatch.Problem("generate:circle", "generate:ellipse/long", levels=(3, 3), align="none")
        self.assertAlmostEqual(problem.mass.sum(), 2.0)
        self.assertTrue((problem.mass > 0).all())

    def test_own_solvers(self):
        energies = {}
        for name in ("newton", "lbfgs", "ceres_lbfgs"):
            minimum = self.flat.minimize(
                name=name,
                metric="l2",
                stop={"max_iterations": 3000, "relative_decrease": 3e-4},
                # Ceres' own tolerances, which end a run where a step gains little, are not those of the others.
                ceres={"function_tolerance": 0, "gradient_tolerance": 0, "parameter_tolerance": 0},
            )
            energies[name] = minimum.energy
            self.assertEqual(minimum.solver, name)
            self.assertEqual(minimum.energy, self.flat.energy(minimum.x))
            self.assertEqual(len(minimum.history), minimum.iterations + 1)
        self.assertLess(max(energies.values()), 1.01 * min(energies.values()))
        few = self.flat.minimize(name="lbfgs", stop={"max_iterations": 3})
        self.assertEqual((few.iterations, few.reason), (3, "max_iterations"))
        steps = []
        stopped = self.flat.minimize(progress=lambda e: steps.append(e) or len(steps) < 2)
        self.assertEqual(stopped.reason, "interrupted")

    @unittest.skipIf(scipy is None, "scipy is not installed")
    def test_scipy(self):
        """Its methods reach what our own solver reaches, from the same start."""
        ours = self.flat.minimize().energy
        objective = self.flat.objective()
        for method, more in (("L-BFGS-B", {}), ("trust-ncg", {"hessp": self.flat.hessp})):
            found = scipy.optimize.minimize(objective, self.flat.x0, jac=True, method=method, **more)
            self.assertAlmostEqual(found.fun, ours, delta=2e-3 * ours)

    def test_the_wall(self):
        x = self.flat.x0.copy()
        x[::2] *= -1
        value, gradient = self.flat.objective(5)(x)
        self.assertEqual(value, 5 * self.flat.energy(self.flat.x0))
        self.assertFalse(gradient.any())
        self.assertEqual(self.flat.objective()(self.flat.x0)[0], self.flat.energy(self.flat.x0))
        for wall in (0, -1, float("inf"), float("nan")):
            with self.assertRaises(shellmatch.InputError):
                self.flat.objective(wall)


if __name__ == "__main__":
    unittest.main()
