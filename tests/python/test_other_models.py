"""The guide's notebook of other models. Its cells are checked always, and run where Landlab and AeoLiS are installed."""

import ast
import importlib.util
import json
import os
import pathlib

import fumon
import pytest

GUIDE = pathlib.Path(os.environ["FUMON_GUIDE"])


def cells():
    book = json.loads((GUIDE / "notebooks" / "other-models.ipynb").read_text())
    return ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code"]


def test_its_cells_call_what_fumon_has():
    owners = {"fumon": fumon, "film": fumon.GrowingFilm, "run": fumon.Results, "sand": fumon.Results}
    called = set()
    for cell in cells():
        for node in ast.walk(ast.parse(cell)):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute):
                continue
            owner = node.func.value
            if isinstance(owner, ast.Name) and owner.id in owners:
                called.add(f"{owner.id}.{node.func.attr}")
                assert callable(getattr(owners[owner.id], node.func.attr)), ast.unparse(node)
    assert called == {"fumon.film", "fumon.open", "film.add", "run.movie", "run.film", "sand.still", "sand.image"}


def test_it_films_both_models(tmp_path, monkeypatch):
    missing = [name for name in ("landlab", "aeolis") if importlib.util.find_spec(name) is None]
    if missing:
        pytest.skip(f"{missing[0]} is not installed")
    monkeypatch.chdir(tmp_path)
    names = {}
    for cell in cells():
        exec(compile(cell, "cell", "exec"), names)  # noqa: S102
    for film in ("dam.mp4", "barchan.mp4", "barchan-tour.mp4", "sand.png"):
        assert (tmp_path / film).stat().st_size > 50_000, film
    assert "of AeoLiS" in names["run"].description
