"""The stubs say what the module has: names, arguments and defaults; all of it has a docstring."""

import ast
import collections
import inspect
import os
import pathlib
import re
import subprocess
import sys
import unittest

import scb
from scb import _scb
from support import SOURCE

PACKAGE = pathlib.Path(scb.__file__).parent


def arguments_of_stub(function):
    """Names, whether they are keywords only, and defaults as text."""
    of, result = function.args, []
    positional = [*of.posonlyargs, *of.args]
    defaults = [None] * (len(positional) - len(of.defaults)) + of.defaults
    for kind, names, values in (("", positional, defaults), ("keyword", of.kwonlyargs, of.kw_defaults)):
        result += [(name.arg, kind, ast.unparse(value) if value else None) for name, value in zip(names, values)]
    return result


def arguments_of_docstring(text, overload):
    """The same of a line of pybind11: the first line, or the line of an overload, from 1."""
    line = next(line for line in text.split("\n") if line.startswith(f"{overload}. ")) if overload else text.split("\n")[0]
    function = ast.parse("def " + re.sub(r"<[^>]*>", "None", line.removeprefix(f"{overload}. ")) + ": ...").body[0]
    return arguments_of_stub(function)


def members(tree):
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node, getattr(_scb, node.name)
        elif isinstance(node, ast.ClassDef):
            for member in node.body:
                yield member, getattr(getattr(_scb, node.name), member.name)


class Signatures(unittest.TestCase):
    stub = ast.parse((PACKAGE / "_scb.pyi").read_text())

    def test_are_those_of_the_stubs(self):
        compared, overloads = 0, collections.Counter()
        for node, thing in members(self.stub):
            decorators = [ast.unparse(decorator) for decorator in node.decorator_list]
            if decorators not in ([], ["overload"]) or node.name in ("__len__", "__bool__"):
                continue
            with self.subTest(node.name):
                overloads[node.name] += bool(decorators)
                told, real = arguments_of_stub(node), arguments_of_docstring(thing.__doc__, overloads[node.name])
                if told and told[0][0] == "self":
                    real = real[1:] if real[0][0] in ("self", "arg0") else real
                    told = told[1:]
                self.assertEqual([a for a in told if a[2] != "..."],
                                 [real[i] for i, a in enumerate(told) if a[2] != "..."])
                self.assertEqual(len(told), len(real))
                compared += 1
        self.assertGreater(compared, 20)

    def test_names_are_those_of_the_stubs(self):
        told = {node.name for node in self.stub.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        self.assertEqual(told, {name for name in vars(_scb) if not name.startswith("__")})
        for node in self.stub.body:
            if isinstance(node, ast.ClassDef):
                real = {n for n, v in vars(getattr(_scb, node.name)).items()
                        if not n.startswith("_") or n.startswith("_repr_")}
                self.assertEqual({m.name for m in node.body if not m.name.startswith("__")}, real)
        self.assertEqual(sorted(scb.__all__), scb.__all__)

    def test_have_docstrings(self):
        for name in scb.__all__:
            if name == "__version__":
                continue
            self.assertTrue(inspect.getdoc(getattr(scb, name)), name)
        for node, thing in members(self.stub):
            if not node.name.startswith("_") or node.name.startswith("_repr_"):
                text = thing.__doc__ or ""
                self.assertTrue(text if node.decorator_list else text.count("\n") > 1, node.name)

    def run_module(self, *arguments):
        done = subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True,
                              cwd=pathlib.Path(__file__).parent)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_pass_the_type_checker(self):
        try:
            import mypy  # noqa: F401
        except ImportError:
            self.skipTest("mypy is not installed")
        os.environ["MYPYPATH"] = str(PACKAGE.parent)
        self.run_module("mypy", "--strict", "--cache-dir", os.devnull, SOURCE / "app/python/examples")
        self.run_module("mypy.stubtest", "scb", "--allowlist", "stubtest.txt", "--ignore-unused-allowlist")


if __name__ == "__main__":
    unittest.main()
