"""The stubs name what there is, with the arguments that it takes."""

import ast
import inspect
import pathlib
import re

import fumon
from fumon import _core

PACKAGE = pathlib.Path(fumon.__file__).parent
STUB = ast.parse((PACKAGE / "_core.pyi").read_text())
MODULES = {file.stem: ast.parse(file.read_text()) for file in sorted(PACKAGE.glob("*.py"))}


def members(body):
    return {node.name: node for node in body
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not is_type_of_dict(node)}


def is_type_of_dict(node):
    return isinstance(node, ast.ClassDef) and [ast.unparse(base) for base in node.bases] == ["TypedDict"]


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
    assert (PACKAGE / "py.typed").exists()


def named(body, path):
    """(where, what) of each class and function that users see."""
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and not node.name.startswith("_"):
            yield f"{path}.{node.name}", node
            if isinstance(node, ast.ClassDef):
                yield from named(node.body, f"{path}.{node.name}")


ALL = [one for name, module in MODULES.items() for one in named(module.body, name)]


def test_all_that_users_see_says_what_it_is():
    assert len(ALL) > 100
    assert [path for path, node in ALL if not ast.get_docstring(node)] == []


def test_attributes_and_arguments_have_types():
    """What mypy --strict does not ask for: attributes whose type every checker would have to infer."""
    bare = []
    for path, node in ALL:
        if isinstance(node, ast.FunctionDef):
            given = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
            bare += [f"{path}({one.arg})" for one in given if one.annotation is None and one.arg not in ("self", "cls")]
            bare += [] if node.returns is not None else [path]
            continue
        typed = {ast.unparse(one.target).removeprefix("self.") for one in ast.walk(node) if isinstance(one, ast.AnnAssign)}
        for one in ast.walk(node):
            targets = [at for target in one.targets for at in ast.walk(target)] if isinstance(one, ast.Assign) else []
            names = {ast.unparse(at)[5:] for at in targets if ast.unparse(at).startswith("self.")}
            bare += [f"{path}.{name}" for name in sorted(public(names) - typed)]
    assert bare == []
