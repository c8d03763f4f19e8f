"""register() gives what the command line writes, to the bit, and a Result that does what it says."""

import copy
import csv
import json
import pathlib
import pickle
import tempfile
import threading
import types
import unittest

import numpy as np
import shapes

import shellmatch


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def matched(self, reference, template, *arguments):
        """The output folder of the command line."""
        shapes.run_program(
            "match", reference, template, "-o", self.folder / "out", "--set", "pictures=none", "--force", *arguments
        )
        return self.folder / "out"

    def same_summary(self, result, folder, but=()):
        """All figures but those of the run."""
        theirs = json.loads((folder / "summary.json").read_text())
        for name in theirs.keys() - {"run", *but}:
            self.assertEqual(result.summary[name], theirs[name], name)


class CommandLine(WithFolder):
    """The same options and vertices: the same bits."""

    def setUp(self):
        super().setUp()
        self.ball, self.egg = shapes.sphere(14), shapes.sphere(16, (1.0, 0.8, 1.4), (0.1, 0.0, 0.2))
        shapes.write_ply(self.folder / "a.ply", *self.ball)
        shapes.write_ply(self.folder / "b.ply", *self.egg)

    def test_arrays(self):
        out = self.matched(
            self.folder / "a.ply",
            self.folder / "b.ply",
            "--levels",
            "3:4",
            "--set",
            "energy.delta=0.5",
            "--set",
            "coverage.weight=2",
        )
        result = shellmatch.register(self.ball, self.egg, levels=(3, 4), energy={"delta": 0.5}, coverage={"weight": 2})
        self.assertTrue(np.array_equal(result.vertices, shapes.read_deformed_ply(out / "deformed.ply")))
        self.same_summary(result, out, but=("reference", "template"))

    def test_built_in_shapes_and_the_paper_profile(self):
        out = self.matched("generate:circle", "generate:ellipse/long", "--levels", "3:5", "--profile", "paper")
        result = shellmatch.register("generate:circle", "generate:ellipse/long", levels=(3, 5), profile="paper")
        with open(out / "deformed.csv") as file:
            rows = [row[:2] for row in csv.reader(file) if row and row[0][:1] in "-0123456789."]
        self.assertTrue(np.array_equal(result.vertices, np.array(rows, dtype=float)))
        self.same_summary(result, out)

    def test_outlines(self):
        a, b = shapes.ellipse(90), shapes.ellipse(110, 1.3, 0.7, 0.2)
        shapes.write_outline(self.folder / "a.csv", a)
        shapes.write_outline(self.folder / "b.csv", b)
        out = self.matched(self.folder / "a.csv", self.folder / "b.csv", "--levels", "3:5", "--align", "none")
        for given in (a, [a], (a, np.stack([np.arange(90), (np.arange(90) + 1) % 90], axis=1))):
            result = shellmatch.register(given, b, levels=(3, 5), align="none")
            with open(out / "deformed.csv") as file:
                rows = [row[:2] for row in csv.reader(file) if row and row[0][:1] in "-0123456789."]
            self.assertTrue(np.array_equal(result.vertices, np.array(rows, dtype=float)))

    def test_landmarks(self):
        chosen = np.array([0, 20, 55, 90, 130, 200, 250])
        on_egg = self.ball[0][chosen] * (1.0, 0.8, 1.4) + (0.1, 0.0, 0.2)
        with open(self.folder / "points.csv", "w") as file:
            file.write("vertex1,x2,y2,z2\n")
            file.writelines(f"{v},{x!r},{y!r},{z!r}\n" for v, (x, y, z) in zip(chosen, on_egg.tolist()))
        out = self.matched(
            self.folder / "a.ply",
            self.folder / "b.ply",
            "--levels",
            "3:4",
            "--align",
            "none",
            "--landmarks",
            self.folder / "points.csv",
            "--set",
            "landmarks.weight=3",
            "--set",
            "landmarks.max_distance=0.2",
        )
        expected = shapes.read_deformed_ply(out / "deformed.ply")
        options = {"levels": (3, 4), "align": "none", "landmarks.weight": 3, "landmarks.max_distance": 0.2}
        for given in ((chosen, on_egg), (self.ball[0][chosen], on_egg, np.ones(7)), self.folder / "points.csv"):
            result = shellmatch.register(self.ball, self.egg, given, **options)
            self.assertTrue(np.array_equal(result.vertices, expected))
        self.assertFalse(np.array_equal(shellmatch.register(self.ball, self.egg, levels=(3, 4), align="none").vertices, expected))
        unequal = shellmatch.register(self.ball, self.egg, (chosen, on_egg, np.arange(1, 8)), **options)
        self.assertFalse(np.array_equal(unequal.vertices, expected))

    def test_a_drawing_turns_with_its_landmarks(self):
        a, b, chosen = shapes.ellipse(90), shapes.ellipse(110, 1.3, 0.7, 0.2), [0, 20, 55]
        points = " ".join(f"{x!r},{-y!r}" for x, y in a.tolist())
        (self.folder / "a.svg").write_text(f'<svg><polygon points="{points}"/></svg>')
        on_b = a[chosen] * (1.3, 0.7)
        options = {"levels": (3, 4), "align": "none", "landmarks.max_distance": 0.2}
        expected = shellmatch.register(a, b, (a[chosen], on_b), **options).vertices
        drawn = shellmatch.register(self.folder / "a.svg", b, (a[chosen] * (1, -1), on_b), **options).vertices
        self.assertTrue(np.array_equal(drawn, expected))

    def test_volumes(self):
        i, j, k = np.meshgrid(*map(np.arange, (24, 22, 20)), indexing="ij")
        values = np.where((i - 12) ** 2 + (j - 11) ** 2 + 1.6 * (k - 10) ** 2 < 64, 3, 0) + np.where(i > 20, 1, 0)
        affine = np.array([[-2.0, 0, 0, 30], [0, 2.5, 0.5, -20], [0, -0.25, 3.0, 10], [0, 0, 0, 1]])
        shapes.write_nifti(self.folder / "scan.nii", values, affine)
        ball = (self.ball[0] * 18 + (8, 10, 40), self.ball[1])
        shapes.write_ply(self.folder / "ball.ply", *ball)
        out = self.matched(self.folder / "ball.ply", f"{self.folder / 'scan.nii'}:3", "--levels", "3:4", "--align", "none")
        expected = shapes.read_deformed_ply(out / "deformed.ply")
        flip = np.diag([-1.0, -1, 1, 1])
        backward, unflipped = affine.copy(), values[::-1]
        backward[:3, 3] = (affine @ [23, 0, 0, 1])[:3]
        backward[:3, 0] *= -1
        for volume in (
            shellmatch.Volume(values, affine, label=3),
            shellmatch.Volume(values.astype(float), affine, label=[3.0]),
            shellmatch.Volume(values * (values > 2), affine, above=2.5),
            shellmatch.Volume(values, flip @ affine, label=3, space="lps"),
            shellmatch.Volume(np.ascontiguousarray(unflipped), backward, label=3),
        ):
            result = shellmatch.register(ball, volume, levels=(3, 4), align="none")
            self.assertTrue(np.array_equal(result.vertices, expected))

    def test_saved(self):
        out = self.matched("generate:circle", "generate:ellipse/long", "--levels", "3:4")
        result = shellmatch.register("generate:circle", "generate:ellipse/long", levels=(3, 4), pictures="none")
        result.save(self.folder / "saved")
        for name in ("deformed.csv", "template.csv", "deformation.vtu", "config.yaml"):
            self.assertEqual((self.folder / "saved" / name).read_bytes(), (out / name).read_bytes(), name)
        points = np.random.default_rng(3).random((50, 2))
        loaded = shellmatch.load(self.folder / "saved")
        self.assertTrue(np.array_equal(loaded.apply(points), result.apply(points)))
        self.assertTrue(np.array_equal(loaded.inverse(points), result.inverse(points), equal_nan=True))
        with self.assertRaises(shellmatch.InputError):
            result.save(self.folder / "saved")
        result.save(self.folder / "saved", force=True)
        shapes.run_program(
            "apply", self.folder / "saved", self.folder / "saved" / "deformed.csv", "-o", self.folder / "moved.csv"
        )

    def test_options_of_a_file(self):
        (self.folder / "experiment.yaml").write_text(
            "cascade: {min_level: 3, max_level: 4}\nalign: {mode: none}\nenergy: {delta: 0.7}\n"
        )
        same = shellmatch.register(self.ball, self.egg, config=self.folder / "experiment.yaml")
        self.assertTrue(
            np.array_equal(
                same.vertices,
                shellmatch.register(self.ball, self.egg, align="none", levels=(3, 4), energy={"delta": 0.7}).vertices,
            )
        )
        self.assertIn("delta: 0.7", same.options)


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ball, cls.egg = shapes.sphere(12), shapes.sphere(12, (1.0, 0.8, 1.3))
        cls.forward = shellmatch.register(cls.ball, cls.egg, levels=(3, 4), align="none")
        cls.backward = shellmatch.register(cls.ball, cls.egg, levels=(3, 4), align={"mode": "none", "direction": "backward"})

    def points(self):
        return np.random.default_rng(5).uniform(-0.9, 0.9, (200, 3)) * (1, 0.8, 1.2)

    def test_vertices_are_moved_by_the_map(self):
        for result in (self.forward, self.backward):
            self.assertLess(np.abs(result.apply(self.ball[0]) - result.vertices).max(), 1e-12)
            self.assertEqual(len(result.vertices), len(self.ball[0]))

    def test_inverse(self):
        for result in (self.forward, self.backward):
            there = result.apply(self.points())
            self.assertLess(np.abs(result.inverse(there) - self.points()).max(), 1e-9)

    def test_jacobian_is_the_derivative(self):
        """Also under a pose, beyond the domain, and of an inverse. Points within a step of a face between cells are left out."""
        turned = shapes.sphere(12, (1.0, 0.8, 1.3))[0] @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]).T + (3, 0, 0)
        landmarks = (np.arange(0, 260, 20), turned[np.arange(0, 260, 20)])
        posed = shellmatch.register(self.egg, (turned, self.egg[1]), landmarks, levels=(3, 4), align="landmarks")
        self.assertGreater(posed.summary["alignment"]["angle"], 80)
        for result in (self.forward, self.backward, posed):
            points, h = np.vstack([self.points(), self.points() * 4]), 1e-6
            differences = np.stack(
                [(result.apply(points + h * e) - result.apply(points - h * e)) / (2 * h) for e in np.eye(3)], axis=2
            )
            errors = np.abs(differences - result.jacobian(points)).max(axis=(1, 2))
            self.assertLess(np.nanmedian(errors), 1e-7)
            self.assertLess(np.mean(errors > 1e-6), 0.02)
            self.assertLess(np.mean(np.isnan(errors)), 0.2)

    def test_single_points_and_shapes(self):
        point = self.points()[0]
        self.assertEqual(self.forward.apply(point).shape, (3,))
        self.assertEqual(self.forward.inverse(point).shape, (3,))
        self.assertEqual(self.forward.jacobian(point).shape, (3, 3))
        self.assertEqual(self.forward.apply(np.empty((0, 3))).shape, (0, 3))
        self.assertTrue(np.array_equal(self.forward.apply(self.points()[::2]), self.forward.apply(self.points())[::2]))

    def test_no_image(self):
        """A point that nothing is carried to has no preimage."""
        folded = np.full(3, 1e6)
        self.assertTrue(
            np.allclose(self.forward.apply(self.forward.inverse(folded)), folded) or np.isnan(self.forward.inverse(folded)).all()
        )

    def test_pickling_says_what_to_do(self):
        for value in (self.forward, self.forward.map):
            for act in (pickle.dumps, copy.copy):
                with self.assertRaisesRegex(TypeError, r"cannot be pickled or copied; save\(\)"):
                    act(value)

    def test_maps_say_of_what_they_are(self):
        self.assertFalse(self.forward.map.is_bent)
        self.assertIn("of space", repr(self.forward.map))
        bent = shellmatch.Map(types.SimpleNamespace(dimension=3, is_bent=True))
        self.assertIn("of a surface", repr(bent))

    def test_arrays_share_memory_and_outlive_the_result(self):
        result = shellmatch.register("generate:circle", "generate:ellipse/long", levels=(3, 3))
        vertices, copy = result.vertices, result.vertices.copy()
        self.assertFalse(vertices.flags.writeable)
        self.assertTrue(np.shares_memory(vertices, result.vertices))
        del result
        self.assertTrue(np.array_equal(vertices, copy))

    def test_figures(self):
        r = self.forward
        self.assertEqual(r.distances.deformed_to_template.shape, (len(self.ball[0]),))
        self.assertEqual(r.distances.template_to_deformed.shape, (len(self.egg[0]),))
        diagonal = np.linalg.norm(np.ptp(self.egg[0], axis=0))
        self.assertAlmostEqual(r.distances.deformed_to_template.max() / diagonal, r.distances.max, delta=0.3 * r.distances.max)
        self.assertIn(r.verdict.outcome, ("matched", "look-here", "not-matched"))
        self.assertAlmostEqual(sum(v for name, v in r.energies.items() if name != "total"), r.energies["total"])
        self.assertEqual(r.summary["levels"][-1]["level"], 4)
        self.assertEqual({row["level"] for row in r.history}, {3, 4})
        self.assertFalse(r.interrupted)
        self.assertIn(r.verdict.outcome, repr(r))
        self.assertRegex(repr(r.distances), rf"^Distances\(deformed_to_template=array {len(self.ball[0])}, .*mean=[0-9.e-]+, .*\)$")
        for value in (r.distances, shellmatch.Volume(np.zeros((20, 20, 20)))):
            self.assertLess(len(repr(value)), 300)

    def test_threads_wait_for_each_other(self):
        expected, found = self.forward.vertices, [None] * 3

        def run(n):
            found[n] = shellmatch.register(self.ball, self.egg, levels=(3, 4), align="none", threads=n % 2 + 1).vertices

        threads = [threading.Thread(target=run, args=(n,)) for n in range(3)]
        for thread in threads:
            thread.start()
        for _ in range(20):  # meanwhile
            self.forward.apply(self.points())
        for thread in threads:
            thread.join()
        for vertices in found:
            self.assertTrue(np.array_equal(vertices, expected))


if __name__ == "__main__":
    unittest.main()
