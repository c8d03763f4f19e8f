#!/usr/bin/env python3
"""Doxygen makes the API reference from the public headers without a warning, and fails where a comment is wrong."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
wrong = "/// \\file\n/// Names \\unknown_command.\nint twice(int number);\n"


def run_doxygen(folder, *settings):
    """With the settings of docs/Doxyfile and these, into the folder."""
    text = "\n".join([(root / "docs/Doxyfile").read_text(), f"OUTPUT_DIRECTORY = {folder}", *settings])
    return subprocess.run(["doxygen", "-"], input=text, cwd=root, capture_output=True, text=True)


class ApiReference(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_headers_have_no_warning(self):
        made = run_doxygen(self.folder)
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        index = (self.folder / "html/index.html").read_text()
        for name in ("match_shapes", "ExperimentOptions", "Minimizer", "BandTerm"):
            self.assertRegex(index, rf'<a class="el" href="[^"]*"[^>]*>shellmatch::{name}</a>')

    def test_a_wrong_comment_is_noticed(self):
        (self.folder / "wrong.h").write_text(wrong)
        made = run_doxygen(self.folder, f"INPUT = {self.folder}/wrong.h")
        self.assertNotEqual(made.returncode, 0)
        self.assertIn("unknown_command", made.stderr)


if __name__ == "__main__":
    if not shutil.which("doxygen"):
        print("skipped: doxygen is not installed (scripts/install-dependencies --developer)")
        sys.exit(77)
    unittest.main()
