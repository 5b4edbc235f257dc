"""The stubs name what there is, with the arguments that it takes."""

import ast
import inspect
import pathlib
import re

import fumon
from fumon import _core

STUB = ast.parse((pathlib.Path(fumon.__file__).parent / "_core.pyi").read_text())


def members(body):
    return {node.name: node for node in body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def arguments_told(function):
    """The arguments' names in pybind11's own signature."""
    signature = function.__doc__.splitlines()[0]
    inside = signature[signature.index("(") + 1:signature.rindex(" ->")]
    return re.findall(r"(?:^|, )(\w+)(?=: )", inside)


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_every_name_is_in_the_stubs():
    stubs = members(STUB.body)
    assert set(stubs) | {"version"} == public(vars(_core))
    for name, node in stubs.items():
        if isinstance(node, ast.ClassDef) and name not in ("Error", "InputError"):
            own = members(node.body)
            assert public(own) == public(vars(getattr(_core, name))), name


def test_functions_take_what_the_stubs_say():
    for name, node in members(STUB.body).items():
        if isinstance(node, ast.FunctionDef):
            assert [argument.arg for argument in node.args.args] == arguments_told(getattr(_core, name)), name
            continue
        for method, inner in members(node.body).items():
            thing = inspect.getattr_static(getattr(_core, name), method)
            if not isinstance(thing, property) and name not in ("Error", "InputError"):
                assert [argument.arg for argument in inner.args.args] == arguments_told(getattr(getattr(_core, name), method))


def test_public_names_have_a_word_of_help():
    for name in fumon.__all__:
        assert getattr(fumon, name).__doc__, name
    assert (pathlib.Path(fumon.__file__).parent / "py.typed").exists()
