"""mypy --strict finds nothing in the package, nor in what a user writes with it."""

import pathlib
import shutil
import subprocess

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
for step in scene.run(every=100):
    height: float = float(step.bed.max())
    count: float = step.measures["dune_count"]
    picture: fumon.Image = step.image()
picture = fumon.render(np.zeros((4, 5)), cell_size=30, camera_azimuth=160)
picture.save("picture.png")
measures: fumon.Measures = fumon.measure(np.zeros((4, 5)), cell_size=(30, 20), periodic=False)
likeness: str = fumon.compare(picture, picture).likeness
model = fumon.Bmi()
model.initialize("terada-barchans")
bed = model.get_value("land_surface__elevation", np.empty(model.get_grid_size(0)))
model.set_value("model.creep_rate", [0.3])
reveal_type(bed)
reveal_type(step.bed)
"""


# The sources of xarray and what it is built on take six times as long as all else.
SETTINGS = """
[mypy]
strict = True
[mypy-xarray.*,pandas.*,netCDF4.*,dask.*]
follow_imports = skip
"""


def test_mypy_strict(tmp_path):
    if not shutil.which("mypy"):
        pytest.skip("mypy is not installed")
    shutil.copytree(PACKAGE, tmp_path / "fumon", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    (tmp_path / "user.py").write_text(USER)
    (tmp_path / "mypy.ini").write_text(SETTINGS)
    done = subprocess.run(["mypy", "--cache-dir", tmp_path / "cache", "fumon", "user.py"], cwd=tmp_path,
                          text=True, capture_output=True)
    told = done.stdout.splitlines()
    assert told[-1].startswith("Success"), done.stdout
    assert "ndarray" in told[0] and "floating" in told[1], done.stdout
