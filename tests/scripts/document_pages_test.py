#!/usr/bin/env python3
"""docs/gallery.md names for every picture of the documentation the script that makes it, and documents show every picture;
docs/index.md leads to each page; code that a page shows is that of the example."""

import fnmatch
import os
import pathlib
import re
import unittest

root = pathlib.Path(__file__).resolve().parent.parent.parent
endings = {".png", ".svg", ".webp", ".gif", ".jpg"}


def table():
    """Pattern to script."""
    rows = re.findall(r"^\| `([^`]+)` \| `((?:scripts|tests/studies)/[^`]+)` \|", (root / "docs/gallery.md").read_text(), re.M)
    return {"docs/" + pattern: script for pattern, script in rows}


def pictures():
    return sorted(str(path.relative_to(root)) for path in (root / "docs").rglob("*") if path.suffix in endings)


def matches(name, pattern):
    """As a shell does: a star is no slash."""
    return name.count("/") == pattern.count("/") and fnmatch.fnmatch(name, pattern)


class Pictures(unittest.TestCase):
    def test_each_stands_in_the_table_once(self):
        self.assertGreaterEqual(len(pictures()), 50)
        for name in pictures():
            self.assertEqual(sum(matches(name, pattern) for pattern in table()), 1, name)

    def test_the_table_names_what_is_there(self):
        for pattern, script in table().items():
            self.assertTrue(any(matches(name, pattern) for name in pictures()), pattern)
            self.assertTrue(os.access(root / script, os.X_OK), script)

    def test_documents_show_each(self):
        shown = {os.path.normpath(page.parent / target) for page in [root / "README.md", *(root / "docs").rglob("*.md")]
                 for target in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text())}
        self.assertEqual([name for name in pictures() if str(root / name) not in shown], [])

    def test_scripts_name_what_they_make(self):
        """A picture that is named in full has its name in the script, or in that which calls it."""
        for pattern, script in table().items():
            if "*" not in pattern and script != "scripts/bench":
                texts = (root / script).read_text() + (root / "scripts/make-docs").read_text()
                self.assertIn(pattern, texts, script)


class Index(unittest.TestCase):
    def test_it_leads_to_each_page(self):
        linked = re.findall(r"\]\(([\w-]+\.md)", (root / "docs/index.md").read_text())
        self.assertEqual(sorted(path.name for path in (root / "docs").glob("*.md") if path.name != "index.md"), sorted(linked))


def without_blanks(text):
    return re.sub(r"\s", "", text)


class Excerpts(unittest.TestCase):
    def test_the_term_is_that_of_the_example(self):
        page = (root / "docs/adding-an-energy.md").read_text()
        blocks = re.findall(r"(?:^    .*\n|^\n(?=    ))+", page, re.M)
        excerpt = next(block for block in blocks if "operator()" in block)
        self.assertIn(without_blanks(excerpt), without_blanks((root / "docs/examples/normal_alignment.h").read_text()))


if __name__ == "__main__":
    unittest.main()
