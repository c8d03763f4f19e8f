"""Shape models, Procrustes analysis and differences of groups: against numpy, and whatever is wrong is refused."""

import copy
import itertools
import pickle
import unittest

import numpy as np
import shapes

import shellmatch

nan = float("nan")


def rotation(rng, d):
    q, r = np.linalg.qr(rng.normal(size=(d, d)))
    q *= np.sign(np.diag(r))
    q[:, 0] *= np.linalg.det(q)
    return q


def moved(rng, points):
    """Each shape by a rigid motion of its own."""
    return np.stack([x @ rotation(rng, x.shape[1]).T + rng.normal(size=x.shape[1]) * 10 for x in points])


def family(seed, n=12, d=3, variation=0.2):
    rng = np.random.default_rng(seed)
    return rng.normal(size=(20, d)) + variation * rng.normal(size=(n, 20, d))


class Models(unittest.TestCase):
    def test_modes_are_those_of_a_singular_value_decomposition(self):
        for d in (2, 3):
            points = family(1, d=d)
            weights = np.linspace(1, 3, 20)
            model = shellmatch.ShapeModel(weights=weights, procrustes="none").fit(points)
            w = np.repeat(weights / weights.sum(), d)
            x = points.reshape(12, -1)
            u, s, vt = np.linalg.svd((x - x.mean(axis=0)) * np.sqrt(w), full_matrices=False)
            np.testing.assert_allclose(model.mean_.ravel(), x.mean(axis=0), atol=1e-14)
            np.testing.assert_allclose(model.variances_, s[:11] ** 2 / 11, rtol=1e-11)
            modes = model.modes_.reshape(11, -1)
            np.testing.assert_allclose((modes * w) @ modes.T, np.eye(11), atol=1e-13)
            np.testing.assert_allclose(np.abs(np.sum(modes * np.sqrt(w) * vt[:11], axis=1)), 1, atol=1e-12)
            np.testing.assert_allclose(model.scores_, ((x - x.mean(axis=0)) * w) @ modes.T, atol=1e-13)
            np.testing.assert_allclose(model.explained_variance_ratio_.sum(), 1, atol=1e-13)
            centred = (model.mean_ - model.weights_ @ model.mean_).ravel()  # positive scores are larger shapes
            self.assertGreater(np.min(modes @ (w * centred)), -0.01 * np.sqrt(w @ centred**2))
            self.assertEqual((model.scores_.shape, model.modes_.shape, model.mean_.shape), ((12, 11), (11, 20, d), (20, d)))

    def test_shapes_and_scores_are_inverse(self):
        rng = np.random.default_rng(2)
        for kind, d in itertools.product(("none", "rigid", "similarity"), (2, 3)):
            points = family(3, d=d)
            if kind != "none":
                points = moved(rng, points)
            if kind == "similarity":
                points = points * rng.uniform(0.5, 2, size=(12, 1, 1))
            model = shellmatch.ShapeModel(procrustes=kind).fit(points)
            np.testing.assert_allclose(model.transform(points), model.scores_, atol=1e-10)
            np.testing.assert_allclose(
                model.transform(moved(rng, points) if kind != "none" else points), model.scores_, atol=1e-10
            )
            back = model.inverse_transform(model.scores_)
            aligned = shellmatch.procrustes(points, procrustes=kind)
            np.testing.assert_allclose(back, aligned.points, atol=1e-10)
            np.testing.assert_allclose(model.mean_, aligned.mean, atol=1e-12)
            two = model.inverse_transform(model.scores_[:, :2])
            expected = model.mean_ + np.einsum("ik,kvd->ivd", model.scores_[:, :2], model.modes_[:2])
            np.testing.assert_allclose(two, expected, atol=1e-12)
            self.assertEqual(model.transform(points[:0]).shape, (0, 11))

    def test_limits(self):
        points = family(4)
        model = shellmatch.ShapeModel(n_modes=3).fit(points)
        self.assertEqual(model.scores_.shape, (12, 3))
        self.assertLess(model.explained_variance_ratio_.sum(), 0.99)
        every = shellmatch.ShapeModel().fit(points)
        np.testing.assert_allclose(model.variances_, every.variances_[:3], rtol=1e-12)
        equal = shellmatch.ShapeModel().fit(np.repeat(points[:1], 4, axis=0))
        self.assertEqual((equal.scores_.shape, equal.modes_.shape), ((4, 0), (0, 20, 3)))
        np.testing.assert_allclose(equal.sample(2), points[[0, 0]], atol=1e-12)

    def test_faces_weigh(self):
        vertices, faces = shapes.sphere(8)
        rng = np.random.default_rng(5)
        points = vertices + 0.1 * rng.normal(size=(6, *vertices.shape))
        model = shellmatch.ShapeModel(faces).fit(points)
        corners = points[:, faces]
        areas = np.linalg.norm(np.cross(corners[:, :, 1] - corners[:, :, 0], corners[:, :, 2] - corners[:, :, 0]), axis=2) / 2
        expected = np.zeros(len(vertices))
        for share in areas / areas.sum(axis=1, keepdims=True) / 3 / 6:
            np.add.at(expected, faces, share[:, None])
        np.testing.assert_allclose(model.weights_, expected, rtol=1e-12)
        outline = shapes.ellipse(30, 2, 1)
        segments = np.stack([np.arange(30), (np.arange(30) + 1) % 30], axis=1)
        planar = shellmatch.ShapeModel(segments).fit(outline + 0.1 * rng.normal(size=(5, 30, 2)))
        self.assertAlmostEqual(planar.weights_.sum(), 1)
        self.assertGreater(planar.weights_.max(), 1.5 * planar.weights_.min())

    def test_samples(self):
        model = shellmatch.ShapeModel().fit(family(6))
        samples = model.sample(4000, seed=3)
        self.assertTrue(np.array_equal(samples[:5], model.sample(5, seed=3)))
        self.assertFalse(np.array_equal(samples[:5], model.sample(5, seed=4)))
        scores = ((samples - model.mean_) * model.weights_[:, None]).reshape(4000, -1) @ model.modes_.reshape(11, -1).T
        np.testing.assert_allclose(scores.var(axis=0), model.variances_, rtol=0.15)

    def test_curves(self):
        points = family(7)
        curves = shellmatch.model_curves(points, procrustes="none", n_samples=50, seed=2)
        model = shellmatch.ShapeModel(procrustes="none").fit(points)
        again = model.curves(50, 2)
        for name, n in (
            ("compactness", 11),
            ("generalisation", 10),
            ("generalisation_error", 10),
            ("specificity", 11),
            ("specificity_error", 11),
        ):
            self.assertEqual(getattr(curves, name).shape, (n,))
            self.assertTrue(np.array_equal(getattr(curves, name), getattr(again, name)))
        np.testing.assert_allclose(curves.compactness, np.cumsum(model.explained_variance_ratio_), rtol=1e-12)
        for n_modes in (1, 4, 10):
            left_out = []
            for i in range(12):
                others = shellmatch.ShapeModel(n_modes=n_modes, procrustes="none").fit(np.delete(points, i, axis=0))
                rest = others.inverse_transform(others.transform(points[i : i + 1]))[0] - points[i]
                left_out.append(np.sqrt(np.mean(np.sum(rest**2, axis=1))))
            self.assertAlmostEqual(curves.generalisation[n_modes - 1], np.mean(left_out), 10)
        every = model.sample(50, 2)
        distances = np.sqrt(np.mean(np.sum((every[:, None] - points) ** 2, axis=3), axis=2)).min(axis=1)
        self.assertAlmostEqual(curves.specificity[-1], distances.mean(), 10)
        self.assertAlmostEqual(curves.specificity_error[-1], distances.std(ddof=1) / np.sqrt(50), 10)

    def test_behaves_as_an_estimator(self):
        """What scikit-learn's clone() does and asks for."""
        faces, weights = np.array([[0, 1, 2]]), None
        model = shellmatch.ShapeModel(faces, weights=weights, n_modes=2, procrustes="similarity")
        self.assertEqual(set(model.get_params()), {"faces", "weights", "n_modes", "procrustes"})
        parameters = {name: copy.deepcopy(value) for name, value in model.get_params(deep=False).items()}
        clone = shellmatch.ShapeModel(**parameters)
        for name, value in clone.get_params(deep=False).items():
            self.assertIs(value, parameters[name])
        self.assertFalse(hasattr(clone.fit(family(8)[:, :20]), "y"))
        self.assertIs(clone.set_params(n_modes=1, faces=None), clone)
        self.assertEqual(clone.fit_transform(family(8), None).shape, (12, 1))
        self.assertTrue(np.array_equal(clone.fit_transform(family(8)), clone.scores_))
        self.assertRaises(shellmatch.InputError, clone.set_params, n_mode=1)
        self.assertIn("n_modes=1", repr(clone))
        for same in (pickle.loads(pickle.dumps(clone)), copy.deepcopy(clone)):
            self.assertTrue(np.array_equal(same.transform(family(9)), clone.transform(family(9))))


class Groups(unittest.TestCase):
    def test_against_numpy(self):
        points = family(10, n=7)
        groups = np.array(["x", "y", "x", "y", "y", "x", "y"])
        result = shellmatch.group_difference(points, groups, procrustes="none")
        self.assertEqual(
            (result.labels, result.sizes, result.n_permutations, result.all_permutations), (("x", "y"), (3, 4), 35, True)
        )

        def statistics(in_b):
            a, b = points[~in_b], points[in_b]
            difference = b.mean(axis=0) - a.mean(axis=0)
            centred = np.concatenate([a - a.mean(axis=0), b - b.mean(axis=0)])
            pooled = np.einsum("ipj,ipk->pjk", centred, centred) / 5
            t = 12 / 7 * np.einsum("pj,pj->p", difference, np.linalg.solve(pooled, difference[:, :, None])[:, :, 0])
            return difference, t, np.sqrt(np.mean(np.sum(difference**2, axis=1)))

        difference, t, distance = statistics(groups == "y")
        np.testing.assert_allclose(result.difference, difference, atol=1e-14)
        np.testing.assert_allclose(result.statistic, t, rtol=1e-9)
        self.assertAlmostEqual(result.distance, distance, 13)
        every = [statistics(np.isin(np.arange(7), chosen)) for chosen in itertools.combinations(range(7), 4)]
        np.testing.assert_allclose(result.p, np.mean([s[1] >= t * (1 - 1e-9) for s in every], axis=0), atol=1e-12)
        greatest = np.array([s[1].max() for s in every])
        np.testing.assert_allclose(result.p_corrected, np.mean(greatest[:, None] >= t * (1 - 1e-9), axis=0), atol=1e-12)
        self.assertAlmostEqual(result.global_p, np.mean([s[2] >= distance * (1 - 1e-9) for s in every]), 12)
        ranks = np.sort(result.p)
        expected = [min(1, min(ranks[j] * 20 / (j + 1) for j in range(20) if ranks[j] >= p)) for p in result.p]
        np.testing.assert_allclose(result.q, expected, atol=1e-12)

    def test_a_planted_difference_is_found(self):
        rng = np.random.default_rng(11)
        points, groups = family(20, n=24, variation=0.1), np.arange(24) % 2 == 1
        points[groups, 3] += (0.35, 0, 0)
        points = moved(rng, points)
        result = shellmatch.group_difference(points, groups, n_permutations=500, seed=1)
        self.assertEqual(np.flatnonzero(result.p_corrected <= 0.05).tolist(), [3])
        self.assertEqual(result.n_permutations, 500)
        self.assertAlmostEqual(np.linalg.norm(result.difference[3]), 0.35, delta=0.1)
        same = shellmatch.group_difference(points, np.where(groups, 7, 2), n_permutations=500, seed=1)
        self.assertEqual(same.labels, (2, 7))
        self.assertTrue(np.array_equal(same.p, result.p))


class Alignment(unittest.TestCase):
    def test_motions_are_found(self):
        rng = np.random.default_rng(13)
        for d in (2, 3):
            one = rng.normal(size=(15, d))
            points = moved(rng, np.repeat(one[None], 6, axis=0))
            kept = points.copy()
            np.testing.assert_allclose(
                shellmatch.procrustes(points, start=one).points, np.repeat(one[None], 6, axis=0), atol=1e-12
            )
            self.assertTrue(np.array_equal(points, kept))  # what was given stays
            sizes = rng.uniform(0.5, 2, size=(6, 1, 1))
            aligned = shellmatch.procrustes(points * sizes, procrustes="similarity", start=one)
            np.testing.assert_allclose(aligned.points, np.repeat(one[None], 6, axis=0), atol=1e-12)
            np.testing.assert_allclose(aligned.mean, one, atol=1e-12)
            self.assertLessEqual(aligned.n_iterations, 3)

    def test_any_array_will_do(self):
        points = family(14)
        expected = shellmatch.procrustes(points).points
        wide = np.zeros((12, 20, 6))
        wide[:, :, ::2] = points
        for same in (points.tolist(), np.asfortranarray(points), wide[:, :, ::2], points.astype(">f8")):
            self.assertTrue(np.array_equal(shellmatch.procrustes(same).points, expected))
        whole = np.round(points * 100)
        self.assertTrue(np.array_equal(shellmatch.procrustes(whole.astype(np.int32)).points, shellmatch.procrustes(whole).points))


class Refusals(unittest.TestCase):
    def refused(self, call, *words):
        with self.assertRaises(shellmatch.InputError) as caught:
            call()
        text = str(caught.exception)
        self.assertNotIn("\n", text)
        for word in words:
            self.assertIn(word, text)

    def test_points(self):
        points, labels = family(15), np.arange(12) < 5
        broken = points.copy()
        broken[4, 7, 1] = nan
        flat = points.copy()
        flat[2] = 1
        functions = (
            shellmatch.procrustes,
            shellmatch.ShapeModel().fit,
            shellmatch.model_curves,
            lambda given: shellmatch.group_difference(given, labels),
        )
        for function in functions:
            for wrong in (
                None,
                3,
                "abc",
                [],
                points[0],
                points[:, :, :1],
                points[:0],
                points[:, :0],
                points + 1j,
                [points[0], points[1][:5]],
                object(),
            ):
                self.refused(lambda: function(wrong))
            self.refused(lambda: function(broken), "shape 4, point 7", "not finite")
            self.refused(lambda: function(flat), "shape 2", "coincide")
        self.refused(lambda: shellmatch.ShapeModel().fit(points[:1]), "at least two shapes")
        self.refused(lambda: shellmatch.model_curves(points[:2]), "at least three shapes")

    def test_parameters(self):
        points, labels = family(16), np.arange(12) < 5
        model = shellmatch.ShapeModel
        for weights in (np.zeros(20), np.r_[-1, np.ones(19)], np.full(20, nan), np.full(20, np.inf)):
            self.refused(lambda: model(weights=weights).fit(points), "some of them positive")
        for weights in (np.ones(5), np.ones((20, 1)), "a"):
            self.refused(lambda: model(weights=weights).fit(points), "weights")
        for faces in ([[0, 1]], [[0, 1, 20]], [[0, 1, -1]], np.zeros((0, 3), int), [[0.5, 1, 2]], 3, [[0, 0, 0]]):
            self.refused(lambda: model(faces).fit(points))
        self.refused(lambda: model([[0, 1]]).fit(points), "triangles")
        self.refused(lambda: model([[0, 1, 2]]).fit(points[:, :, :2]), "segments")
        self.refused(lambda: model([[0, 1, 2]], weights=np.ones(20)).fit(points), "one of them")
        for kind in ("affine", None, 3, ["rigid"]):
            self.refused(lambda: model(procrustes=kind).fit(points), f"procrustes={kind!r}")
        for n_modes in (0, -1, 2.5, "3", True, 2**40):
            self.refused(lambda: model(n_modes=n_modes).fit(points), "n_modes")
        fitted = model(n_modes=2).fit(points)
        self.refused(lambda: fitted.transform(points[:, :5]), "the model has (20, 3)")
        self.refused(lambda: fitted.transform(points[:, :, :2]))
        self.refused(lambda: fitted.inverse_transform(np.zeros((2, 3))), "at most 2")
        self.refused(lambda: fitted.inverse_transform(np.zeros(2)))
        self.refused(lambda: fitted.sample(-1), "n=-1")
        self.refused(lambda: fitted.sample(2, seed=-1), "seed")
        self.refused(lambda: fitted.sample(2, seed=2**64), "seed")
        self.assertEqual(fitted.sample(0).shape, (0, 20, 3))
        self.refused(lambda: fitted.curves(), "limited to 2")
        self.refused(lambda: model().fit(points).curves(0), "n_samples")
        for call in (
            model().curves,
            model().sample,
            lambda: model().transform(points),
            lambda: model().inverse_transform([[1.0]]),
        ):
            self.refused(call, "fit")
        for start in (points[0, :5], points, points[0] * nan, points[0] * 0):
            self.refused(lambda: shellmatch.procrustes(points, start=start))
        for groups in (labels[:5], labels * 0, np.arange(12), [None, "a"] * 6, np.arange(12) < 1, labels[:, None]):
            self.refused(lambda: shellmatch.group_difference(points, groups))
        self.refused(lambda: shellmatch.group_difference(points, labels, n_permutations=0), "n_permutations")


if __name__ == "__main__":
    unittest.main()
