#!/usr/bin/env python3
"""scripts/mutate --check: every entry that cannot be made as it stands is found, and no other."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parent.parent.parent / "scripts" / "mutate"
SOURCE = "int a = 1;\n  int b = 2;\nint c = 2;\n"
CMAKE = "shellmatch_test(grid_octree SOURCES octree_test.cpp LINK x)\n"
TEST = "TEST(Octree, Refines) {\nTYPED_TEST(Cells, Have) {\n"
GOOD = "# a comment\ngrid/octree.cpp: grid_octree/Octree*:Cells/*\n- a = 1;\n-   int b\n+ a = 2;\n~ why\n\n"


class Check(unittest.TestCase):
    def check(self, entries):
        """Exit code and output for the good entry with others behind it; these begin at line 8."""
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {"grid/octree.cpp": SOURCE,
                               "tests/grid/CMakeLists.txt": CMAKE, "tests/grid/octree_test.cpp": TEST,
                               "tests/mutations.txt": GOOD + entries}.items():
                file = pathlib.Path(folder, name)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            run = subprocess.run([sys.executable, SCRIPT, "--check", "--root", folder], text=True, capture_output=True)
            return run.returncode, run.stdout

    def expect_one(self, entries, text):
        code, output = self.check(entries)
        self.assertEqual(code, 1, output)
        self.assertEqual(output.count("out of date: "), 1, output)
        self.assertIn(text, output)

    def test_entries_that_can_be_made_pass(self):
        code, output = self.check("- c = 2\n+ c = 3\n")
        self.assertEqual(code, 0, output)
        self.assertIn("2 errors, 0 ", output)

    def test_a_text_that_occurs_twice(self):
        self.expect_one("- = 2;\n+ = 3;\n", "line 8: the old text occurs 2 times")

    def test_a_text_that_is_gone(self):
        self.expect_one("- d = 1;\n+\n\n", "line 8: the old text occurs 0 times")

    def test_an_error_without_an_old_text(self):
        self.expect_one("\n+ int d;\n", "line 9: the old text occurs 0 times")

    def test_an_error_that_changes_nothing(self):
        self.expect_one("- int a\n+ int a\n", "line 8: old and new text are the same")

    def test_a_file_that_is_gone(self):
        self.expect_one("grid/quadtree.cpp: grid_octree\n- b\n+ c\n", "grid/quadtree.cpp does not exist")

    def test_a_program_that_is_gone(self):
        self.expect_one("grid/octree.cpp: octree\n- int a\n+ int d\n", "no test program test_octree")

    def test_a_test_that_is_gone(self):
        self.expect_one("grid/octree.cpp: grid_octree/Quadtree*\n- int a\n+ int d\n", "is called Quadtree*")


if __name__ == "__main__":
    unittest.main()
