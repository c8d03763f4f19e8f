#!/usr/bin/env python3
"""What the studies of documents share (scripts/lib), and the counts of scripts/study alignment-study."""
import math
import pathlib
import random
import sys
import tempfile
import unittest
from types import SimpleNamespace

root = pathlib.Path(__file__).resolve().parent.parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(root / "scripts"), str(root / "tests/studies")]

from alignments import cases, tables, wrong_landmarks  # noqa: E402
from closing import tables as closing  # noqa: E402
from lib import meshes, transforms  # noqa: E402
from lib.document import put_between  # noqa: E402
from verdicts.table import table_text  # noqa: E402

corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, 3.0)]
sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def volume(points, faces):
    """Six times that of a body whose triangles face outward."""
    total = 0.0
    for a, b, c in ([points[v] for v in f] for f in faces):
        total += sum(a[i] * (b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3]) for i in range(3))
    return total


class Transforms(unittest.TestCase):
    def test_rotations_keep_lengths_and_orientation(self):
        source, seen = random.Random(1), []
        for _ in range(5):
            points = transforms.rotated(corners, transforms.random_rotation(source))
            for i in range(4):
                for j in range(i):
                    self.assertAlmostEqual(math.dist(points[i], points[j]), math.dist(corners[i], corners[j]), 12)
            self.assertAlmostEqual(volume(points, sides), 6, 12)
            self.assertGreater(max(math.dist(p, q) for p, q in zip(points, corners)), 0.1)
            self.assertNotIn(points, seen)
            seen.append(points)

    def test_mirror_images_face_outward(self):
        self.assertAlmostEqual(volume(*transforms.mirrored(corners, sides, "y")), 6, 12)


class Meshes(unittest.TestCase):
    def test_what_is_written_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "body.off"
            meshes.write_off(path, corners, sides)
            self.assertEqual(meshes.read(path), (corners, sides))


class Documents(unittest.TestCase):
    def test_text_goes_between_its_marks(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "page.md"
            path.write_text("before\n<!-- a -->\nold\n<!-- b -->\nafter\n")
            put_between(path, "<!-- a -->", "<!-- b -->", "new\n")
            self.assertEqual(path.read_text(), "before\n<!-- a -->\nnew\n<!-- b -->\nafter\n")
            with self.assertRaises(SystemExit):
                put_between(path, "<!-- a -->", "<!-- c -->", "")


class VerdictStudy(unittest.TestCase):
    def test_a_page_lists_wrong_verdicts(self):
        distances = {"deformed_to_template": {"mean": 0.1}, "template_to_deformed": {"mean": 0.1, "max": 0.2}, "uncovered": 0}
        results = [
            SimpleNamespace(
                error=None,
                is_right=is_right,
                case=SimpleNamespace(name=name, kind=""),
                summary={"verdict": {"outcome": outcome}, "distance": distances, "flipped_share": 0, "area_distortion": {"p5": 1, "p95": 2}},
            )
            for name, is_right, outcome in (("a", True, "matched"), ("b", True, "not-matched"), ("c", False, "matched"), ("d", False, "look-here"))
        ]
        self.assertEqual(len(table_text(results).splitlines()), 6)
        listed = [line.split(" | ")[0] for line in table_text(results, wrong_only=True).splitlines()[2:]]
        self.assertEqual(listed, ["| b", "| c"])


class ClosingStudy(unittest.TestCase):
    def test_files_are_counted_by_what_becomes_of_them(self):
        rows = [
            "| file | strictly | made up | now | mean error | s |",
            "| --- |",
            "| a | read | - | matched | 1e-3 | 1 |",
            "| b | open | 8 % | look-here | 2e-3 | 1 |",
            "| c | no faces |  | no faces |  | 0 |",
        ]
        counts = closing.dirty_counts(rows)
        self.assertEqual(counts, "Of 3 files 1 are read strictly, 1 are matched after closing, and 1 are refused.")


class AlignmentStudy(unittest.TestCase):
    def test_sixty_pairs_are_distinct(self):
        self.assertEqual((len(cases.poses()), len(cases.kinds())), (35, 25))
        pairs = cases.poses() + cases.kinds()
        self.assertEqual(len(set(pairs)), 60)

    def test_counts_of_doubt(self):
        used, doubtful = {"doubtful": False}, {"doubtful": True}
        rows = [(("a.off", "b.off"), 0.01, used), (("a.off", "c.off"), 0.01, doubtful), (("a.off", "d.off"), 0.2, doubtful),
                (("a.off", "torus/thick"), None, doubtful), (("b.off", "e.off"), None, {"as_it_lies": True})]
        text = tables.doubt_counts(rows)
        self.assertIn("| 2 right | 1 | 0 | 1 |", text)
        self.assertIn("| 3 wrong | 0 | 1 | 2 |", text)
        self.assertIn("67 % are wrong (precision)", text)
        self.assertIn("67 % are called so (recall)", text)
        self.assertIn("| a | torus/thick | other kind | wrong | doubtful |", tables.doubt_table(rows))
        unexpected = tables.doubt_table(rows, unexpected_only=True).splitlines()[2:]
        self.assertEqual([line.split(" | ")[1] for line in unexpected], ["c", "e"])

    def test_wrong_landmarks_are_as_wrong_as_they_are_said_to_be(self):
        source = random.Random(2)
        points = [tuple(source.random() for _ in range(3)) for _ in range(400)]
        variants = dict(wrong_landmarks.variants(points, list(enumerate(points)), source))
        size = transforms.diagonal(points)
        errors = {name: [math.dist(points[i], points[j]) / size for i, j in lines] for name, lines in variants.items()}
        self.assertEqual(max(errors["exact"]), 0)
        self.assertEqual(sum(e > 0.3 for e in errors["one in ten wrong"]), 5)
        self.assertLess(sum(errors["noise 2 %"]), sum(errors["noise 5 %"]))


if __name__ == "__main__":
    unittest.main()
