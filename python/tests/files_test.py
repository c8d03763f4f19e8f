"""Names of files in any encoding, and the folders that save() writes."""

import contextlib
import os
import pathlib
import resource
import sys
import tempfile
import unittest
import warnings

import numpy as np
import shapes

import shellmatch

options = {"levels": (3, 3), "align": "none"}


@contextlib.contextmanager
def largest_file(n_bytes):
    """No file may become larger meanwhile; Python ignores the signal that comes with it."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (n_bytes, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def table(path):
    return np.genfromtxt(path, delimiter=",", names=True)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_what_is_missing_is_said(self):
        result = shellmatch.register("generate:circle", "generate:ellipse/long", **options)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            result.save(self.folder / "whole")
        size = (self.folder / "whole/report.html").stat().st_size
        self.assertTrue(all(p.stat().st_size < size / 2 for p in self.folder.glob("whole/*") if p.name != "report.html"))
        with self.assertWarnsRegex(shellmatch.ShellmatchWarning, "report.html is missing") as caught, largest_file(size // 2):
            result.save(self.folder / "without")
        self.assertEqual(caught.filename, __file__)
        self.assertFalse((self.folder / "without/report.html").exists())
        self.assertTrue((self.folder / "without/summary.json").exists())

    def test_outlines_are_written_along_their_rings(self):
        """Whatever the order of the vertices: a file of outlines has no other way to tell what follows what."""
        ring, template, n = shapes.ellipse(60, 1.2, 0.8), shapes.ellipse(50, 1.3, 0.7), 50
        shellmatch.register(ring, template, pictures="none", **options).save(self.folder / "plain")
        places = np.random.default_rng(8).permutation(n + 3)[:n]
        vertices = np.full((n + 3, 2), 0.1)
        vertices[places] = template
        segments = np.stack([places, np.roll(places, -1)], axis=1)
        shuffled = shellmatch.register(ring, (vertices, segments), pictures="none", **options)
        shuffled.save(self.folder / "shuffled")
        for name in ("deformed.csv", "template.csv"):
            self.assertEqual((self.folder / "shuffled" / name).read_bytes(), (self.folder / "plain" / name).read_bytes(), name)
        numbers = table(self.folder / "plain/deformed.csv")["template_v0"].astype(int)
        self.assertTrue(np.array_equal(shuffled.attributes["template_v0"], places[numbers]))
        again = shellmatch.register((vertices, segments), ring, pictures="none", **options)
        again.save(self.folder / "again")
        written = table(self.folder / "again/deformed.csv")
        self.assertTrue(np.array_equal(np.stack([written["x"], written["y"]], axis=1), again.vertices[places]))

    @unittest.skipIf(sys.getfilesystemencoding() != "utf-8", "names have another encoding here")
    def test_names_that_are_no_text(self):
        shapes.write_outline(os.fsencode(self.folder) + b"/ring-\xe9.csv", shapes.ellipse(60))
        name = os.path.join(self.folder, next(n for n in os.listdir(self.folder)))
        with self.assertRaises(UnicodeEncodeError):
            name.encode()
        expected = shellmatch.register(shapes.ellipse(60), shapes.ellipse(60, 1.2, 0.8), **options)
        for given in (name, pathlib.Path(name)):
            result = shellmatch.register(given, shapes.ellipse(60, 1.2, 0.8), **options)
            self.assertTrue(np.array_equal(result.vertices, expected.vertices))
        self.assertIn("reference", result.options)
        result.save(name + "-out")
        self.assertTrue(np.array_equal(shellmatch.load(name + "-out").apply(np.eye(2)), result.apply(np.eye(2))))
        for call in (
            lambda: shellmatch.register(name + "x", name, **options),
            lambda: shellmatch.register(name, name, name + "x", **options),
            lambda: shellmatch.register(name, name, {"file": name + "x"}, **options),
            lambda: shellmatch.register(name, name, config=name + "x", **options),
            lambda: shellmatch.load(name + "x"),
            lambda: shellmatch.register(name, name, **{**options, "input.unit\udce9": "mm"}),
        ):
            with self.assertRaises(shellmatch.InputError) as caught:
                call()
            str(caught.exception).encode()  # can be printed

    def test_things_that_are_no_names(self):
        result = shellmatch.register("generate:circle", "generate:circle", **options)
        for call in (lambda: result.save(3), lambda: shellmatch.load(3)):
            with self.assertRaisesRegex(shellmatch.InputError, "folder: a int"):
                call()
        with self.assertRaisesRegex(shellmatch.InputError, "cannot be the name of a file"):
            shellmatch.register("\ud800.csv", "generate:circle", **options)


if __name__ == "__main__":
    unittest.main()
