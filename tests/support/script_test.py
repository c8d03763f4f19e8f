"""What tests of scripts share."""

import argparse
import pathlib
import tempfile
import unittest


def path_option(option):
    """The value of this option of the command line, an absolute path, and the words that are left for unittest."""
    parser = argparse.ArgumentParser()
    parser.add_argument(option, type=pathlib.Path, required=True, dest="value")
    arguments, rest = parser.parse_known_args()
    return arguments.value.resolve(), rest


class ScriptTest(unittest.TestCase):
    """With a folder that is gone afterwards."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assert_refused(self, result, script, code, words):
        """Ended with this code and one message of this script that has these words, on stderr alone."""
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stderr.count(f"{script}: "), 1, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)
