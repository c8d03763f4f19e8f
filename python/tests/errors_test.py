"""Whatever is wrong is refused with a typed error of one line; nothing crashes."""

import pathlib
import re
import tempfile
import types
import unittest

import numpy as np
import shapes

import shellmatch

options = {"levels": (3, 3), "align": "none"}
nan = float("nan")


class Refused(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.ball = shapes.sphere(8)
        cls.outline = shapes.ellipse(40)

    def refused(self, call, *words):
        with self.assertRaises(shellmatch.Error) as caught:
            call()
        text = str(caught.exception)
        self.assertNotIn("\n", text)
        self.assertTrue(text)
        for word in words:
            self.assertIn(word, text)

    def shape_refused(self, shape, *words):
        """In either place."""
        for pair in ((shape, self.ball), (self.ball, shape)):
            self.refused(lambda: shellmatch.register(*pair, **options), *words)

    def test_kinds(self):
        self.assertTrue(issubclass(shellmatch.InputError, (shellmatch.Error, ValueError)))
        self.assertTrue(issubclass(shellmatch.OutOfMemoryError, (shellmatch.ResourceError, MemoryError)))
        self.assertFalse(issubclass(KeyboardInterrupt, shellmatch.Error))
        with self.assertRaises(shellmatch.InputError):
            shellmatch.register("generate:circle", "generate:nothing")
        with tempfile.NamedTemporaryFile() as file, self.assertRaises(shellmatch.InputError):
            shellmatch.register("generate:circle", "generate:circle", **options).save(file.name)

    def test_messages_speak_of_arguments(self):
        with tempfile.TemporaryDirectory() as folder:
            result = shellmatch.register("generate:circle", "generate:circle", **options)
            result.save(folder + "/out")
            self.refused(lambda: result.save(folder + "/out"), "choose another, or replace it with force=True")
        for said, words in (
            ("stop at level 7 instead, with --levels 3:7", "stop at level 7 instead, with levels=(3, 7)"),
            ("a lower finest level (--levels) needs less", "a lower finest level (levels=(coarsest, finest)) needs less"),
            ("try --align landmarks", 'try align="landmarks"'),
            ("(--set align.direction=auto; docs/alignment.md)", '(**{"align.direction": "auto"}; docs/alignment.md)'),
        ):
            self.assertEqual(str(shellmatch.InputError(said)), words)

    def test_no_word_of_the_command_line_is_left(self):
        """In what a matching or its result may say: every text in its sources that has an option with hyphens."""
        root = pathlib.Path(__file__).resolve().parents[2]
        of_commands = ("derivative_check", "run_gradient_check.cpp", "yaml_options", "cascade.cpp")  # what no function reaches
        n = 0
        for file in sorted([*root.glob("matching/**/*.cpp"), *root.glob("base/*.cpp")]):
            if any(word in str(file) for word in of_commands):
                continue
            source = re.sub(r'"\n\s*"', "", file.read_text())  # literals that go on in the next line
            for text in re.findall(r'"((?:[^"\\\n]|\\.)*)"', source):
                if re.search(r"--[a-z]", text):
                    n += 1
                    self.assertNotRegex(str(shellmatch.Error(text.replace("{}", "3"))), r"--[a-z]| -o\b", file)
        self.assertGreater(n, 5)

    def test_sections_and_lists_that_hold_themselves(self):
        section, values = {}, []
        section["more"] = section
        values.append(values)
        for name in ("energy", "align", "landmarks"):
            self.refused(lambda: shellmatch.register("generate:circle", "generate:circle", **{name: section}), name, "hold itself?")
        for name in ("energy", "levels", "landmarks"):
            self.refused(lambda: shellmatch.register("generate:circle", "generate:circle", **{name: values}), name)
        self.shape_refused(values)

    def test_things_that_are_no_shapes(self):
        for shape in (
            None,
            3,
            2.5,
            b"a.ply",
            object(),
            {},
            {"vertices": 1},
            np.float64(3),
            (),
            (1,),
            (1, 2, 3),
            set(),
            "",
            "not-there.ply",
            "noending",
            types.SimpleNamespace(vertices=1, faces=2),
            types.SimpleNamespace(points=1, faces=2),
            types.SimpleNamespace(points=1, cells=[]),
        ):
            self.shape_refused(shape)

    def test_vertices(self):
        vertices, faces = self.ball
        for wrong in (
            vertices[:, :1],
            vertices.ravel(),
            vertices[None],
            np.empty((0, 3)),
            np.empty((0, 0)),
            np.array(1.0),
            np.array([]),
            [],
            [[]],
            vertices + 1j,
            vertices.astype(str),
            vertices.astype(object),
            [[1, 2, 3], [1, 2]],
            None,
            "abc",
            np.c_[vertices, vertices],
            vertices.astype("M8[s]"),
        ):
            self.shape_refused((wrong, faces))
        for value in (nan, np.inf, -np.inf, 1e60, 1e308):
            broken = vertices.copy()
            broken[17, 1] = value
            self.shape_refused((broken, faces))
        self.shape_refused((vertices * 0, faces))
        self.shape_refused((vertices * 1e-200, faces))
        self.shape_refused((np.zeros_like(vertices) + 3, faces))

    def test_the_row_is_named(self):
        vertices = self.ball[0].copy()
        vertices[17, 1] = nan
        self.shape_refused((vertices, self.ball[1]), "row 17")
        faces = self.ball[1].copy()
        faces[5, 2] = 10**6
        self.shape_refused((self.ball[0], faces), "row 5", "1000000")

    def test_faces(self):
        vertices, faces = self.ball
        for wrong in (
            faces[:, :2],
            faces.ravel(),
            faces[None],
            np.empty((0, 3), int),
            np.array(0),
            [],
            [[]],
            [[0, 1]],
            [0, 1, 2],
            faces + 0.5,
            faces.astype(float),
            faces > 3,
            None,
            "abc",
            [[0, 1, "x"]],
            [[0, 1, 2.5]],
            [[0, 1, None]],
            7,
        ):
            self.shape_refused((vertices, wrong))
        for value in (-1, -(2**40), len(vertices), 2**31, 2**32, 2**40, 2**62):
            broken = faces.copy()
            broken[3, 0] = value
            self.shape_refused((vertices, broken))
        self.shape_refused((vertices, np.full((4, 3), 2**64 - 1, dtype=np.uint64)))
        self.shape_refused((vertices, [[0, 1, 2], [0, 1, 2**70]]))
        self.shape_refused((vertices, faces * 0))

    def test_outlines(self):
        ring = self.outline
        for wrong in (
            [],
            [[]],
            [ring, []],
            ring[:2],
            ring[:, :1],
            np.empty((0, 2)),
            ring * nan,
            ring * 0,
            ring[None],
            [ring, 3],
            np.array(3.0),
            [[1, 2], [3, 4]],
            (ring, np.array([[0, 1], [1, 2]])),
            (ring, np.array([[0, 99]])),
            (ring, np.array([[-1, 0]])),
            (ring, [[0, 1, 2]]),
            (ring, np.empty((0, 2), int)),
        ):
            self.refused(lambda: shellmatch.register(wrong, self.outline, **options))
            self.refused(lambda: shellmatch.register(self.outline, wrong, **options))

    def test_dimensions_that_differ(self):
        self.refused(lambda: shellmatch.register(self.ball, self.outline, **options), "dimension")
        self.refused(lambda: shellmatch.register(self.outline, "generate:hand", **options), "dimension")

    def test_meshes_of_pyvista(self):
        vertices, faces = self.ball
        for wrong in ([3, 0, 1], [2, 0, 1], [-1], [3, 0, 1, 99], [0], [10**12, 1]):
            self.shape_refused(types.SimpleNamespace(points=vertices, faces=np.array(wrong)))
        self.shape_refused(
            types.SimpleNamespace(points=vertices, cells=np.array([4, 0, 1, 2, 3]), extract_surface=None), "extract_surface"
        )

    def test_meshes_of_meshio(self):
        self.shape_refused(types.SimpleNamespace(points=self.ball[0], cells=[("tetra", np.array([[0, 1, 2, 3]]))]), "tetra")

    def test_volumes(self):
        values = np.zeros((6, 6, 6))
        values[2:4, 2:4, 2:4] = 1
        affine = np.eye(4)
        volume = shellmatch.Volume
        broken = values.copy()
        broken[1, 2, 3] = nan
        singular, last = affine.copy(), affine.copy()
        singular[:, 0] = singular[:, 1]
        last[3, 0] = 0.5
        for wrong in (
            volume(values[0]),
            volume(values[:1]),
            volume(values[:0]),
            volume(None),
            volume("abc"),
            volume(values + 1j),
            volume(broken, affine, label=1),
            volume(values, affine[:3]),
            volume(values, singular),
            volume(values, last),
            volume(values, affine * nan),
            volume(values, np.zeros((4, 4))),
            volume(values, affine, label=7),
            volume(values, affine, label=[]),
            volume(values, affine, label=nan),
            volume(values, affine, above=5),
            volume(values, affine, above=nan),
            volume(values, affine, label=1, above=0),
            volume(values, affine, label="a"),
            volume(values, affine, space="rsa"),
            volume(values * 0),
            volume(values * 1e300),
            volume((values * 2**40).astype(np.int64), affine),
        ):
            self.shape_refused(wrong)
        for kind in (np.int64, float):  # of single precision these are the label 2**24 as well
            self.shape_refused(volume((values * (2**24 + 1)).astype(kind), affine, label=2**24), "16777216")
            self.shape_refused(volume(values.astype(kind), affine, label=2**24 + 1), "16777217")
        for several in ([], [0.5, 0.7], np.ones((2, 2))):
            self.shape_refused(volume(values, affine, above=several), "above", "expected one")

    def test_landmarks(self):
        v, n = self.ball[0], np.arange(5)
        for wrong in (
            3,
            (),
            (n,),
            (n, v),
            (n, n[:3]),
            (v[:5], v[:5, :2]),
            (v[:5] * nan, v[:5]),
            (n - 1, n),
            (n, n + 10**6),
            (n + 0.5, n),
            (n, n, n[:2]),
            (n, n, -n),
            (n, n, n * nan),
            (n, n, 1 + n, 1),
            "not-there.csv",
            ("a.csv", n),
            ("a", "b", "c"),
            {"fil": 1},
            (v[:5] + 50, v[:5]),
            object(),
            ([[1, 2], [3]], n),
        ):
            self.refused(lambda: shellmatch.register(self.ball, self.ball, wrong, **options))

    def test_points(self):
        result = shellmatch.register(self.ball, self.ball, **options)
        for function in (result.apply, result.inverse, result.jacobian):
            for wrong in (
                None,
                3,
                "abc",
                [[1, 2]],
                [1, 2],
                [[1, 2, nan]],
                np.zeros((2, 2, 3)),
                np.empty((0, 2)),
                [[1, 2, 3], [1, 2]],
                [[1j, 0, 0]],
            ):
                self.refused(lambda: function(wrong))

    def test_problems(self):
        problem = shellmatch.Problem(self.outline, self.outline * 1.1, **options)
        x = problem.x0
        for function in (
            problem.energy,
            problem.gradient,
            problem.energy_and_gradient,
            problem.terms,
            problem.map,
            problem.minimize,
        ):
            for wrong in (3, "abc", x[:-1], np.r_[x, 0], x[:, None], x * nan, x + 1j, np.array(0.0), []):
                self.refused(lambda: function(wrong))
        self.refused(lambda: problem.hessp(x, x[:3]))
        self.refused(lambda: problem.minimize(nam="lbfgs"), "did you mean")
        self.refused(lambda: problem.minimize(name="lbfg"), "did you mean")
        for wrong in (2, 4, 3.0, "3", -1, 10**9, True):
            self.refused(lambda: shellmatch.Problem(self.outline, self.outline, level=wrong, **options))
        self.refused(lambda: shellmatch.Problem(self.outline, self.outline, start="finer", **options))

    def test_files(self):
        self.refused(lambda: shellmatch.load("not-there"))
        result = shellmatch.register(self.outline, self.outline, **options)
        self.refused(lambda: result.save(""))
        with tempfile.TemporaryDirectory() as folder:
            open(f"{folder}/deformation.vtu", "w").close()
            self.refused(lambda: shellmatch.load(folder))
            self.refused(lambda: result.save(folder))

    def test_progress_that_is_no_function(self):
        with self.assertRaises(TypeError):
            shellmatch.register(self.ball, self.ball, progress=3, **options)

    def test_too_much_memory(self):
        self.refused(lambda: shellmatch.register(self.ball, self.ball, levels=(12, 15), align="none"))
        self.refused(lambda: shellmatch.Problem(self.ball, self.ball, levels=(12, 15), align="none"))


if __name__ == "__main__":
    unittest.main()
