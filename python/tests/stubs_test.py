"""The stubs of the compiled module say what it has, and every public name has its documentation."""

import ast
import inspect
import pathlib
import re
import unittest

import shellmatch
from shellmatch import _core

interface = pathlib.Path(_core.__file__).parent / "_core.pyi"


def parameters_of_stub(function):
    return [argument.arg for argument in function.args.args if argument.arg != "self"]


def parameters_of_module(function):
    """From the first line that pybind11 gives it: name(self: T, x: U) -> V."""
    line = function.__doc__.splitlines()[0]
    inside = line[line.index("(") + 1 : line.rindex(") ->")]
    return [
        name
        for name in re.findall(r"(?:^|, )(\w+)(?=:)", re.sub(r"[\[(][^\[\]()]*[\])]", "", re.sub(r"\[[^\[\]]*\]", "", inside)))
        if name != "self"
    ]


def public(names):
    return {name for name in names if not name.startswith("_") or name == "__init__"}


class Stubs(unittest.TestCase):
    def setUp(self):
        self.tree = ast.parse(interface.read_text())

    def test_names_agree(self):
        functions = {n.name for n in self.tree.body if isinstance(n, ast.FunctionDef)}
        classes = {n.name: n for n in self.tree.body if isinstance(n, ast.ClassDef)}
        values = {n.target.id for n in self.tree.body if isinstance(n, ast.AnnAssign)}
        self.assertEqual(functions | set(classes) | values, public(vars(_core)))
        for name, node in classes.items():
            theirs = public(vars(getattr(_core, name)))
            ours = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            if "__init__" not in ours:  # made by functions alone
                self.assertRaises(TypeError, getattr(_core, name))
                theirs -= {"__init__"}
            self.assertEqual(ours, theirs, name)

    def test_parameters_agree(self):
        n_compared = 0
        for node in self.tree.body:
            inner = node.body if isinstance(node, ast.ClassDef) else [node]
            owner = getattr(_core, node.name) if isinstance(node, ast.ClassDef) else _core
            for function in inner:
                if not isinstance(function, ast.FunctionDef):
                    continue
                theirs = getattr(owner, function.name)
                if isinstance(theirs, property):
                    self.assertIn("property", [d.id for d in function.decorator_list])
                    continue
                self.assertEqual(parameters_of_stub(function), parameters_of_module(theirs), f"{node.name}.{function.name}")
                n_compared += 1
        self.assertGreater(n_compared, 15)

    def test_the_package_is_typed(self):
        self.assertTrue((interface.parent / "py.typed").exists())
        for name in shellmatch.__all__:
            thing = getattr(shellmatch, name)
            if inspect.isfunction(thing):
                self.assertIn("return", thing.__annotations__, name)

    def test_everything_public_is_documented(self):
        self.assertEqual(sorted(shellmatch.__all__), sorted(set(shellmatch.__all__)))
        for name in shellmatch.__all__:
            thing = getattr(shellmatch, name)
            if isinstance(thing, str):
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)):
                        self.assertTrue(inspect.getdoc(value), f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
