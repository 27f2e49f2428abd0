#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The stubs say what the module has: the same names, methods, parameters and defaults, and everything has a docstring."""
import ast
import inspect
import re
import unittest
from pathlib import Path

import triax

STUB = ast.parse(Path(triax.__file__).with_suffix(".pyi").read_text())
DUNDERS = {"__getattr__", "__getitem__", "__contains__", "__iter__", "__len__", "__dir__", "__init__"}


def ours(kind):
    """Names of a class of the module that a user meets."""
    return {name for name in vars(kind) if not name.startswith("_") or name in DUNDERS}


def parameters_of_stub(function):
    """[(name, has a default, keyword only)] without self."""
    a = function.args
    first = len(a.args) - len(a.defaults)
    found = [(p.arg, i >= first, False) for i, p in enumerate(a.args)]
    found += [(p.arg, d is not None, True) for p, d in zip(a.kwonlyargs, a.kw_defaults)]
    return [p for p in found if p[0] != "self"]


def parameters_of_module(function):
    """The same from the signature that pybind11 writes into the docstring."""
    text = function.__doc__.splitlines()
    signature = next((line for line in text if line.startswith("1. ")), text[0])
    inside = signature[signature.index("(") + 1:signature.rindex(") ->")]
    found, only, depth, part = [], False, 0, ""
    for c in inside + ",":
        depth += c in "([{<"
        depth -= c in ")]}>"
        if c != "," or depth > 0:
            part += c
            continue
        part = part.strip()
        if part == "*":
            only = True
        elif part:
            found.append((re.split("[:=]", part)[0].strip(), " = " in part, only))
        part = ""
    return [p for p in found if p[0] != "self" and not p[0].startswith("arg0")]


class Stubs(unittest.TestCase):
    def test_every_public_name_is_in_the_stubs(self):
        said = {n.name for n in STUB.body if isinstance(n, (ast.ClassDef, ast.FunctionDef))}
        said |= {n.target.id for n in STUB.body if isinstance(n, ast.AnnAssign)}
        self.assertEqual(said - {"__version__"}, set(triax.__all__))
        self.assertIn("__version__", said)

    def test_classes_have_the_members_that_the_stubs_say(self):
        for node in (n for n in STUB.body if isinstance(n, ast.ClassDef)):
            if node.name in ("BadInput", "WorkFailed"):
                continue
            said = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            has = ours(getattr(triax, node.name))
            if "__init__" not in said:  # what only the module makes
                has.discard("__init__")
                with self.assertRaises(TypeError):
                    getattr(triax, node.name)()
            self.assertEqual(said, has, node.name)

    def test_properties_are_properties_and_methods_have_the_same_parameters(self):
        compared = 0
        for node in (n for n in STUB.body if isinstance(n, ast.ClassDef)):
            for member in (n for n in node.body if isinstance(n, ast.FunctionDef)):
                real = inspect.getattr_static(getattr(triax, node.name), member.name)
                decorated = {d.id for d in member.decorator_list if isinstance(d, ast.Name)}
                self.assertEqual("property" in decorated, isinstance(real, property), f"{node.name}.{member.name}")
                if isinstance(real, property) or member.name in DUNDERS - {"__init__", "__getitem__"}:
                    continue
                self.assertEqual(parameters_of_stub(member), parameters_of_module(real), f"{node.name}.{member.name}")
                compared += 1
        self.assertGreater(compared, 8)

    def test_functions_have_the_same_parameters(self):
        for node in (n for n in STUB.body if isinstance(n, ast.FunctionDef)):
            self.assertEqual(parameters_of_stub(node), parameters_of_module(getattr(triax, node.name)), node.name)

    def test_everything_has_a_docstring(self):
        for name in triax.__all__:
            real = getattr(triax, name)
            if isinstance(real, tuple):
                continue
            self.assertTrue(real.__doc__, name)
            for member in ours(real) - DUNDERS if isinstance(real, type) else ():
                if name not in ("BadInput", "WorkFailed"):
                    self.assertTrue(inspect.getattr_static(real, member).__doc__, f"{name}.{member}")

    def test_docstrings_say_more_than_the_signature(self):
        for name in ("replay", "simulate", "element", "probe", "domain", "materials", "soil", "soils", "calibrate"):
            self.assertGreater(len(getattr(triax, name).__doc__.split("->", 1)[1].split()), 8, name)


if __name__ == "__main__":
    unittest.main()
