"""The blocks of the guide's page on Python, in their order."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess

import pytest

GUIDE = pathlib.Path(os.environ["FUMON_GUIDE"]) / "python.md"


def test_the_guides_blocks_run(tmp_path, monkeypatch, capsys):
    blocks = re.findall(r"^```python\n(.*?)^```", GUIDE.read_text(), re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 6
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        if any(f"import {other}" in block and not importlib.util.find_spec(other) for other in ("matplotlib", "landlab")):
            continue
        exec(compile(block, str(GUIDE), "exec"), names)
    told = capsys.readouterr().out
    for promised in re.findall(r"print\(.*\) +# (.*)", "\n".join(blocks)):
        assert promised in told
    made = {"hill.png", "last.png", "barchans.mp4", "growth.webp", "flood.nc", "second.png", "flood.mp4", "tour.mp4", "rising.mp4",
            "erosion.mp4"}
    for file, package in (("axes.pdf", "matplotlib"), ("rivers.mp4", "landlab")):
        if importlib.util.find_spec(package):
            made.add(file)
    assert {file.name for file in tmp_path.iterdir()} == made


def test_the_blocks_on_coupling_run(tmp_path, monkeypatch, capsys):
    page = (GUIDE.parent / "bmi.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 3
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        exec(compile(block, "bmi.md", "exec"), names)
    told = capsys.readouterr().out
    assert "fumon sand" in told and "smoother: True" in told


def test_the_blocks_on_a_notebook_run(tmp_path, monkeypatch, capsys):
    page = (GUIDE.parent / "notebook.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    assert len(blocks) == 4
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        exec(compile(block, "notebook.md", "exec"), names)
    assert capsys.readouterr().out == "('bed.high', 'model.creep_rate')\nTrue\nTrue\n"


def test_the_block_in_cpp_runs(tmp_path):
    library = os.environ.get("FUMON_BMI_LIBRARY")
    if not library or not shutil.which("c++"):
        pytest.skip("FUMON_BMI_LIBRARY names no library, or there is no C++ compiler")
    page = (GUIDE.parent / "bmi.md").read_text()
    (program,) = re.findall(r"^```cpp\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    (tmp_path / "coupled.cpp").write_text(program)
    (tmp_path / "fumon").mkdir()
    for header in ("bmi.h", "bmi_library.h"):
        shutil.copy(GUIDE.parents[2] / "src/bmi" / header, tmp_path / "fumon")
    (tmp_path / "my.toml").write_text('[model]\nname = "sand"\n[grid]\nnx = 12\nny = 8\n[run]\nsteps = 4\n')
    folder = os.path.dirname(library)
    subprocess.run(["c++", "-std=c++20", "-I.", "coupled.cpp", "-L" + folder, "-lfumonbmi", "-Wl,-rpath," + folder, "-o",
                    "coupled"], cwd=tmp_path, check=True)
    done = subprocess.run(["./coupled", "my.toml"], cwd=tmp_path, check=True, text=True, capture_output=True)
    assert done.stdout == "96 cells after 3 steps\n"
