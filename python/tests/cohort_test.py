"""register_cohort(): one shape on many, their mean, and what becomes of subjects that cannot be read."""

import unittest

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

    def test_mistakes(self):
        with self.assertRaisesRegex(shellmatch.InputError, "include='all'"):
            shellmatch.register_cohort(self.subjects[0], self.subjects, include="all")
        with self.assertRaisesRegex(shellmatch.InputError, "atlas faces"):
            shellmatch.register_cohort((np.zeros((4, 3)), np.zeros((2, 2), dtype=int)), [])
        with self.assertRaisesRegex(shellmatch.InputError, "rounds=-1"):
            shellmatch.register_cohort(self.subjects[0], self.subjects, rounds=-1)


if __name__ == "__main__":
    unittest.main()
