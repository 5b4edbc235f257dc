"""A wheel, in an environment of its own: it has its data with it, and says what it is."""

import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

import fumon

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(fumon._core.__file__).parents[2]

CODE = """
import importlib.metadata, pathlib, fumon
assert pathlib.Path(fumon.__file__).is_relative_to({place!r}), fumon.__file__
scene = fumon.Scene("only-here", grid_nx=48, grid_ny=32, run_steps=2, image_width=320, image_height=180)
print(scene.at(2).image().shape)
about = importlib.metadata.metadata("fumon")
assert about["License"] == "MIT" and about["Author"] and about["Summary"]
assert any("Typed" in one for one in about.get_all("Classifier"))
assert "Homepage, https://fumon.example" in about.get_all("Project-URL")
assert sorted(about.get_all("License-File")) == ["LICENSE", "copyright"], about.get_all("License-File")
papers = {{path.name: path.read_text() for path in importlib.metadata.files("fumon") if ".dist-info" in str(path.parent)}}  # newer ones lie in its licenses/
assert "Fabio Crameri" in papers["copyright"] and "Permission is hereby granted" in papers["LICENSE"]
share = pathlib.Path(fumon.__file__).parent / "share"
assert (share / "assets/copyright").read_text() == papers["copyright"]
assert about["Description-Content-Type"] == "text/markdown" and "NumPy" in about.get_payload()
"""


def test_a_wheel_works_in_an_environment_of_its_own(tmp_path):
    for module in ("pip", "wheel", "setuptools", "venv"):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is not installed")
    (tmp_path / "src").mkdir()  # pip leaves files beside what it builds
    for name in ("assets", "shaders", "scenes", "CMakeLists.txt", "LICENSE"):
        (tmp_path / name).symlink_to(SOURCE / name)
    subprocess.run(["cp", "-r", SOURCE / "src/python", tmp_path / "src/python"], check=True)
    env = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "FUMON_DATA_DIR")}
    env["FUMON_BUILD"] = str(BUILD)
    env["FUMON_HOMEPAGE"] = "https://fumon.example"
    quiet = ["--quiet", "--disable-pip-version-check", "--no-deps", "--no-index"]
    subprocess.run([sys.executable, "-m", "pip", "wheel", *quiet, "--no-build-isolation", "-w", tmp_path / "wheels",
                    tmp_path / "src/python"], check=True, env=env, timeout=120)
    wheel, = (tmp_path / "wheels").glob("fumon-*.whl")
    place = tmp_path / "environment"
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", place], check=True, env=env)
    assert not (tmp_path / "src/python/LICENSE").exists()
    python = place / "bin/python"
    subprocess.run([python, "-m", "pip", "install", *quiet, wheel], check=True, env=env, timeout=120)
    scenes, = place.glob("lib/python*/site-packages/fumon/share/scenes")
    (scenes / "terada-ripples.toml").rename(scenes / "only-here.toml")
    done = subprocess.run([python, "-c", CODE.format(place=str(place))], cwd="/", env=env, text=True, capture_output=True)
    assert (done.stdout, done.stderr, done.returncode) == ("(180, 320, 3)\n", "", 0)
