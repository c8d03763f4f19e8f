"""What the documents show runs."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import shapes

try:
    import scipy.optimize
except ImportError:
    scipy = None


def run(code, folder):
    return subprocess.run([sys.executable, *code], cwd=folder, capture_output=True, text=True, env=dict(os.environ))


class Documents(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_the_example_of_the_readme(self):
        text = (shapes.source_folder / "README.md").read_text()
        lines = re.search(r"(?:^    .*\n)+", text[text.index("\n    import shellmatch\n") :], re.MULTILINE)[0].splitlines()
        self.assertLess(len(lines), 12)
        result = run(["-c", "\n".join(line[4:] for line in lines)], self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, "matched|look-here")
        self.assertTrue((pathlib.Path(self.folder) / "hand" / "summary.json").exists())

    def test_the_example_of_statistics(self):
        text = (shapes.source_folder / "docs/python.md").read_text()
        block = re.search(r"(?:^(?:    .*)?\n)+", text[text.index("\n    import numpy as np\n") + 1 :], re.MULTILINE)[0]
        lines = [line[4:] for line in block.splitlines()]
        self.assertTrue(12 < len(lines) < 25, len(lines))
        lines.append(
            "print(share, np.ptp(wide[:, 0]), scores.shape, len(random_shapes), curves.specificity[0], where.all(), result.n_permutations)"
        )
        result = run(["-c", "\n".join(lines)], self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        share, width, n, n_modes, n_shapes, specificity, found, n_permutations = (
            result.stdout.replace("(", "").replace(")", "").replace(",", "").split()
        )
        self.assertGreater(float(share), 0.99)
        self.assertGreater(float(width), 2.3)
        self.assertEqual((n, n_modes, n_shapes, n_permutations), ("6", "5", "10", "20"))
        self.assertLess(float(specificity), 0.1)
        self.assertEqual(found, "False")  # of 20 groupings the least p is 0.1

    @unittest.skipIf(scipy is None, "scipy is not installed")
    def test_the_solver_study(self):
        result = run(
            [shapes.source_folder / "python/examples/solver_study.py", "generate:circle", "generate:ellipse/long", "4"],
            self.folder,
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = {line[:24].strip(): line[24:].split() for line in result.stdout.splitlines()[2:]}
        self.assertEqual(len(rows), 6)
        for name, (_, gap, *_) in rows.items():
            self.assertLess(float(gap), 1e-3, name)


if __name__ == "__main__":
    unittest.main()
