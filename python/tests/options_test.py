"""Options are those of the YAML, checked by the same code."""

import re
import unittest

import numpy as np
import shapes

import shellmatch

pair = ("generate:circle", "generate:ellipse/long")


class Options(unittest.TestCase):
    def refused(self, words, **options):
        with self.assertRaises(shellmatch.InputError) as caught:
            shellmatch.register(*pair, **{"levels": (3, 3), **options})
        self.assertNotIn("\n", str(caught.exception))
        for word in words:
            self.assertIn(word, str(caught.exception))

    def set_to(self, key, expected, **options):
        """What config.yaml has for the key after a run."""
        text = shellmatch.register(*pair, **{"levels": (3, 3), "align": "none", **options}).options
        lines = [line for line in text.splitlines() if re.match(rf"\s*{key}:", line)]
        self.assertIn(f"{key}: {expected}", [line.strip() for line in lines])

    def test_nested_and_dotted_names_are_the_same(self):
        self.set_to("delta", "0.25", energy={"delta": 0.25})
        self.set_to("delta", "0.25", **{"energy.delta": 0.25})
        self.set_to("max_iterations", "7", solver={"stop": {"max_iterations": 7}})
        self.set_to("max_iterations", "7", **{"solver.stop": {"max_iterations": 7}})

    def test_values_of_all_kinds(self):
        self.set_to("delta", "0.5", energy={"delta": np.float32(0.5)})
        self.set_to("delta", "2", energy={"delta": np.array(2)})
        self.set_to("threads", "1", threads=np.int16(1))
        self.set_to("enabled", "false", resume={"enabled": False})
        self.set_to("boundary", "dirichlet", energy={"boundary": "dirichlet"})
        self.set_to("fallback", '["lbfgs", "newton"]', solver={"fallback": ("lbfgs", "newton")})
        self.set_to("fallback", "[]", solver={"fallback": []})
        self.set_to("unit", '"µm: a # b"', input={"unit": "µm: a # b"})

    def test_levels_of_solvers(self):
        result = shellmatch.register(*pair, levels=(3, 4), align="none", solver={"levels": {"3": {"name": "lbfgs"}}})
        self.assertEqual({row["level"]: row["solver"] for row in result.history}, {3: "lbfgs", 4: "newton"})

    def test_the_last_one_wins(self):
        self.set_to("max_level", "4", levels=(3, 3), **{"cascade.max_level": 4})
        self.set_to("mode", "none", align="auto", **{"align.mode": "none"})

    def test_files_of_options_are_named(self):
        for wrong in (3, True, ["a.yaml"]):
            self.refused(["config", type(wrong).__name__], config=wrong)
        self.refused(["config", r"\ud800"], config="\ud800.yaml")
        self.refused(["not-there.yaml"], config="not-there.yaml")

    def test_maps_of_files_are_no_start(self):
        for call in (shellmatch.register, shellmatch.Problem):
            with self.assertRaisesRegex(shellmatch.InputError, "start.map"):
                call(*pair, levels=(3, 3), align="none", **{"start.map": "somewhere"})

    def test_misspelt_keys_are_refused_with_the_nearest(self):
        self.refused(["unknown key", "did you mean energy.delta?"], energy={"delat": 1})
        self.refused(["unknown key", "did you mean energy.delta?"], **{"energy.delat": 1})
        self.refused(["unknown key", "cascade"], cascde={"nu": 1})
        self.refused(["unknown key"], levels_=(3, 4))

    def test_values_that_are_no_values(self):
        self.refused(["energy.delta"], energy={"delta": float("nan")})
        self.refused(["energy.delta"], energy={"delta": float("inf")})
        self.refused(["energy.delta", "x >= 0"], energy={"delta": -1})
        self.refused(["energy.delta"], energy={"delta": "much"})
        self.refused(["energy.delta"], energy={"delta": True})
        self.refused(["energy.delta"], energy={"delta": ""})
        self.refused(["energy.delta"], energy={"delta": [1, 2]})
        self.refused(["energy.delta"], energy={"delta": "1\n2"})
        self.refused(["energy.delta", "NoneType"], energy={"delta": None})
        self.refused(["energy.delta", "complex"], energy={"delta": 1j})
        self.refused(["energy is a section"], energy=3)
        self.refused(["energy", "empty"], energy={})
        self.refused(["no word"], energy={3: 1})
        self.refused(["threads"], threads=1.5)
        self.refused(["threads"], threads=10**30)
        self.refused(["profile", "did you mean paper?"], profile="pper")
        self.refused(["input.reference"], input={"reference": "a.ply"})

    def test_levels_that_are_none(self):
        for levels in (3, (3,), (3, 4, 5), "37", (3.5, 4), (0, 3), (4, 3), (3, 99), ("a", "b"), {"a": 1}):
            self.refused(["level"], levels=levels)

    def test_align(self):
        self.refused(["align.mode", "did you mean"], align="atuo")
        self.refused(["align"], align=3)
        self.refused(["align", "unknown key"], align={"mod": "none"})

    def test_config_that_is_none(self):
        with self.assertRaises(shellmatch.InputError):
            shellmatch.register(*pair, config="not-there.yaml")

    def test_all_options_are_those_of_the_program(self):
        """A key of each section of `shellmatch config` is taken."""
        text = shellmatch.register(*pair, levels=(3, 3), align="none").options
        for section in re.findall(r"^(\w+):$", shapes.run_program("config"), re.MULTILINE):
            self.assertIn(f"\n{section}:\n", text)


if __name__ == "__main__":
    unittest.main()
