"""register_cohort(): one shape on many, their mean, and what becomes of subjects that cannot be read."""

import unittest
import unittest.mock
import warnings

import numpy as np

import shellmatch

SETTINGS = {"levels": (3, 4), "align": "none", "threads": 1}


def ellipse(a, b, n=60):
    angles = 2 * np.pi * np.arange(n) / n
    return np.stack([a * np.cos(angles), b * np.sin(angles)], axis=1)


class Cohorts(unittest.TestCase):
    def setUp(self):
        self.subjects = [ellipse(1.0, 0.8), ellipse(1.1, 0.75), ellipse(1.2, 0.7)]

    def test_the_mean_of_ellipses_has_the_mean_axes(self):
        cohort = shellmatch.register_cohort(self.subjects[0], self.subjects, rounds=2, **SETTINGS)
        self.assertEqual(cohort.points.shape, (3, 60, 2))
        np.testing.assert_allclose(np.hypot(cohort.atlas[:, 0] / 1.1, cohort.atlas[:, 1] / 0.75), 1, atol=0.015)
        model = cohort.model()
        self.assertGreater(model.explained_variance_ratio_[0], 0.95)
        self.assertEqual(model.scores_.shape[0], 3)

    def test_without_rounds_the_atlas_stays(self):
        told = []
        cohort = shellmatch.register_cohort(
            self.subjects[1], self.subjects[:2], progress=lambda *what: told.append(what[:2]), **SETTINGS
        )
        np.testing.assert_array_equal(cohort.atlas, self.subjects[1])
        self.assertEqual(told, [(0, 0), (0, 1)])
        np.testing.assert_array_equal(cohort.points[0], cohort.results[0].vertices)

    def test_a_subject_that_cannot_be_read_costs_itself(self):
        cohort = shellmatch.register_cohort(self.subjects[0], [self.subjects[1], "nowhere.csv"], **SETTINGS)
        self.assertEqual(cohort.included.tolist(), [0])
        self.assertIsNone(cohort.results[1])
        self.assertIn("nowhere.csv", cohort.errors[1])
        with self.assertRaisesRegex(shellmatch.InputError, "none can be used for the mean.*nowhere"):
            shellmatch.register_cohort(self.subjects[0], ["nowhere.csv"], rounds=1, **SETTINGS)

    def test_closed_outlines_and_segments_in_any_order(self):
        subject, closed = self.subjects[1], np.vstack([self.subjects[0], self.subjects[0][:1]])
        order = np.random.default_rng(6).permutation(60)
        place = np.argsort(order)
        shuffled = (self.subjects[0][order], np.stack([place, np.roll(place, -1)], axis=1))
        for atlas, vertices in ((closed, closed), (shuffled, shuffled[0])):
            cohort = shellmatch.register_cohort(atlas, [subject, self.subjects[2]], rounds=1, **SETTINGS)
            self.assertEqual(cohort.points.shape, (2, *vertices.shape))
            # Each point goes to where its own direction meets the subject, or near it.
            turn = np.angle((vertices @ [1, 1j]) * np.conj(cohort.points[0] @ [1, 1j]))
            self.assertLess(np.abs(turn).max(), 0.3)
            self.assertEqual(cohort.model().mean_.shape, vertices.shape)

    def test_subjects_of_an_iterator_are_there_in_every_round(self):
        told = []
        cohort = shellmatch.register_cohort(
            self.subjects[0], iter(self.subjects[:2]), rounds=1, progress=lambda *what: told.append(what[:2]), **SETTINGS
        )
        self.assertEqual(told, [(0, 0), (0, 1), (1, 0), (1, 1)])
        self.assertEqual(cohort.included.tolist(), [0, 1])

    def test_what_all_matchings_share_is_checked_before_them(self):
        broken, many = self.subjects[0].copy(), np.arange(5)
        broken[4, 1] = np.nan
        crossed = self.subjects[0].copy()
        crossed[[10, 30]] = crossed[[30, 10]]
        for atlas, arguments, words in (
            (self.subjects[0], {"energy": {"delat": 1}}, "did you mean energy.delta"),
            (self.subjects[0], {"config": "not-there.yaml"}, "not-there.yaml"),
            (self.subjects[0], {"landmarks": (many + 60, self.subjects[1][:5])}, "vertex 60"),
            (self.subjects[0], {"levels": 3}, "levels=3"),
            (broken, {}, "atlas.*row 4"),
            (crossed, {}, "atlas.*crosses"),
        ):
            told = []
            with self.assertRaisesRegex(shellmatch.InputError, words):
                shellmatch.register_cohort(atlas, self.subjects, progress=lambda *what: told.append(what), **{**SETTINGS, **arguments})
            self.assertEqual(told, [])
        with self.assertRaisesRegex(shellmatch.InputError, "procrustes="):
            shellmatch.register_cohort(self.subjects[0], self.subjects, procrustes="afine", **SETTINGS)

    def test_an_error_of_our_own_is_none_of_a_subject(self):
        def fails(*_, **__):
            raise shellmatch.InternalError("broken")

        with unittest.mock.patch("shellmatch.cohort.register", fails), self.assertRaisesRegex(shellmatch.InternalError, "broken"):
            shellmatch.register_cohort(self.subjects[0], self.subjects, **SETTINGS)

    def test_why_there_is_no_mean(self):
        with self.assertRaisesRegex(shellmatch.InputError, "there are none"):
            shellmatch.register_cohort(self.subjects[0], [], rounds=1, **SETTINGS)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", shellmatch.ShellmatchWarning)
            outcome = shellmatch.register(self.subjects[0], ellipse(1.0, 0.05), **SETTINGS).verdict.outcome
            self.assertNotEqual(outcome, "matched")
            with self.assertRaisesRegex(shellmatch.InputError, f"its verdict is {outcome}$"):
                shellmatch.register_cohort(self.subjects[0], [ellipse(1.0, 0.05)], rounds=1, include="matched", **SETTINGS)

    def test_mistakes(self):
        with self.assertRaisesRegex(shellmatch.InputError, "include='all'"):
            shellmatch.register_cohort(self.subjects[0], self.subjects, include="all")
        with self.assertRaisesRegex(shellmatch.InputError, "atlas faces"):
            shellmatch.register_cohort((np.zeros((4, 3)), np.zeros((2, 2), dtype=int)), [])
        with self.assertRaisesRegex(shellmatch.InputError, "rounds=-1"):
            shellmatch.register_cohort(self.subjects[0], self.subjects, rounds=-1)


if __name__ == "__main__":
    unittest.main()
