"""What tests of pages in a browser share."""

import argparse
import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts/lib"))
import browser  # noqa: E402


class PageCase(unittest.TestCase):
    """One browser for all pages but those that ask for another one. No page may complain."""

    @classmethod
    def setUpClass(cls):
        cls.browser = browser.Browser(width=1100, height=450)
        cls.addClassCleanup(cls.browser.__exit__)

    def open(self, page):
        self.assertEqual(self.browser.open(page)[0], "true")

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [])

    def changes(self, action, *, changed, same=()):
        """These parts of the page look different after the action, and those do not."""
        before = {name: self.browser.picture(name) for name in (*changed, *same)}
        action()
        self.browser.settle()
        for name, picture in before.items():
            (self.assertNotEqual if name in changed else self.assertEqual)(self.browser.picture(name), picture, name)


def begin(description, option):
    """Reads the option of the command line, which is needed. Returns it and the words for unittest; skips where there is no browser."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument(option, required=True, dest="value")
    arguments, rest = parser.parse_known_args()
    if lacking := browser.missing():
        print(f"skipped: not installed: {lacking} (scripts/install-dependencies --browser)")
        sys.exit(1 if os.environ.get("SHELLMATCH_BROWSER") == "required" else 77)
    return arguments.value, [sys.argv[0], *rest]
