"""mypy --strict finds nothing in the package, nor in what a user writes with it; pyright knows the types of its symbols."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

import fumon

PACKAGE = pathlib.Path(fumon.__file__).parent

USER = """
import copy
import pickle

import numpy as np

import fumon

scene = fumon.Scene("terada-barchans", seed=2, **{"model.creep_rate": 0.3})
other: fumon.Scene = copy.deepcopy(scene)
again: fumon.Scene = pickle.loads(pickle.dumps(scene))
scene = fumon.Scene("terada-barchans", bed=np.zeros((4, 5)), cell_size=(2, 3), origin="upper", run_steps=3,
                    **{"model.creep_rate": 0.3})
for step in scene.run(every=100):
    height: float = float(step.bed.max())
    count: float = step.measures["dune_count"]
    picture: fumon.Image = step.image()
picture = fumon.render(np.zeros((4, 5)), cell_size=30, camera_azimuth=160)
picture.save("picture.png")
shown: fumon.FigureAxes = fumon.figure_axes(object(), scene, step=3, camera_projection="map")
across, down = shown.project([1.0, 2.0], 3.0)
measures: fumon.Measures = fumon.measure(np.zeros((4, 5)), cell_size=(30, 20), periodic=False)
likeness: str = fumon.compare(picture, "picture.png").likeness
sha: str = fumon.fingerprint(picture)["pixels_sha256"]
fumon.render([[1.5, 2.0], [3.0, 4.0]], overlay=[{"kind": "scale-bar"}], sun_azimuth=np.float32(3))
over = {"model.creep_rate": [0.1, 0.2]}
scene.sweep(over, 2)
scene.sweep({("grid.nx", "grid.ny"): [32, 64], "model.creep_rate": np.linspace(0.1, 0.2, 3)}, range(3))
fumon.movie(scene.run(), "run.mp4")
fumon.movie([scene.at(4), scene.at(8)], "steps.mp4")
fumon.movie(np.zeros((3, 4, 5)), "beds.mp4", cell_size=30, camera_azimuth=160)
model = fumon.Bmi()
model.initialize("terada-barchans")
bed = model.get_value("land_surface__elevation", np.empty(model.get_grid_size(0)))
model.set_value("model.creep_rate", [0.3])
reveal_type(bed)
reveal_type(step.bed)
reveal_type(model.get_grid_shape(0, np.empty(2, dtype=np.int32)))
"""

WRONG = """
import numpy as np

import fumon

fumon.render(np.zeros((4, 5)), origin="north")
fumon.render(np.zeros((4, 5)), camera_azimuth=object())
fumon.fingerprint("picture.png")["sha"]
fumon.compare("a.png", "b.png").likeness == "alike"
fumon.Bmi().get_grid_shape(0, [1, 2])
"""


# The sources of xarray and what it is built on take six times as long as all else.
SETTINGS = """
[mypy]
strict = True
[mypy-xarray.*,pandas.*,netCDF4.*,dask.*]
follow_imports = skip
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """What mypy says of the package and of both files of a user."""
    if not shutil.which("mypy"):
        pytest.skip("mypy is not installed")
    folder = tmp_path_factory.mktemp("types")
    shutil.copytree(PACKAGE, folder / "fumon", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    (folder / "user.py").write_text(USER)
    (folder / "wrong.py").write_text(WRONG)
    (folder / "mypy.ini").write_text(SETTINGS)
    done = subprocess.run(["mypy", "--cache-dir", folder / "cache", "fumon", "user.py", "wrong.py"], cwd=folder,
                          text=True, capture_output=True)
    return done.stdout.splitlines()


def test_mypy_strict(told):
    assert [line for line in told[:-1] if ": error:" in line and not line.startswith("wrong.py:")] == []
    shown = [line for line in told if "Revealed type" in line]
    assert all("ndarray" in line for line in shown)
    assert re.search("floating|float64", shown[1]) and "signedinteger" in shown[2], shown


def test_mypy_sees_wrong_use(told):
    lines = [line.split(":")[1] for line in told if line.startswith("wrong.py:") and ": error:" in line]
    assert lines == [str(6 + n) for n in range(5)], told


def test_pyright_knows_the_types():
    if not shutil.which("pyright"):
        pytest.skip("pyright is not installed")
    done = subprocess.run(["pyright", "--pythonpath", sys.executable, "--verifytypes", "fumon", "--ignoreexternal", "--outputjson"],
                          env={**os.environ, "PYTHONPATH": str(PACKAGE.parent)}, text=True, capture_output=True)
    told = json.loads(done.stdout)["typeCompleteness"]
    unknown = [one["name"] for one in told["symbols"] if one["isExported"] and not one["isTypeKnown"]]
    assert told["completenessScore"] >= 0.99, unknown
