"""ParaView itself opens what runs leave: fields.nc as it comes, a series of .vts, meshes. It is skipped without pvpython."""

import json
import os
import pathlib
import re
import shutil
import subprocess

import pytest

RUN = "[output]\nfields_every = 2\nframes = false\nmovie = false\n"
SCENES = {
    "sand": '[model]\nname = "sand"\n[grid]\nnx = 24\nny = 16\n[run]\nsteps = 6\n',
    "sandpile": '[model]\nname = "sandpile"\n[grid]\nnx = 21\nny = 21\n[run]\nsteps = 6\n',
    "dunes": '[model]\nname = "dunes"\n[grid]\nnx = 24\nny = 16\ncell_size = 2\n[bed]\nkind = "noise"\nhigh = 4\n[run]\nsteps = 6\n',
    "gully": '[model]\nname = "gully"\n[grid]\nnx = 24\nny = 16\n[run]\nsteps = 6\n',
    "water": '[model]\nname = "water"\nrain = 30\n[grid]\nnx = 24\nny = 16\ncell_size = 2\n[run]\nsteps = 6\n',
    "airflow": '[model]\nname = "airflow"\n[grid]\nnx = 32\nny = 1\n[run]\nsteps = 6\n',
    "static": '[model]\nname = "static"\n[grid]\nnx = 24\nny = 16\ncell_size = 2\n[bed]\nkind = "noise"\nhigh = 1\n[run]\nsteps = 6\n',
}
MESHES = ["dunes.vts", "dunes.ply", "dunes.obj", "dunes.glb", "dunes.stl"]

# Opens files as its dialogue does, with all properties as they come, at their last time.
READER = """
import json
import sys

from paraview.simple import NetCDFReader, OpenDataFile

told = {}
for file in sys.argv[1:]:
    proxy = NetCDFReader(FileName=[file]) if file.endswith(".nc") else OpenDataFile(file)
    proxy.UpdatePipelineInformation()
    times = [float(time) for time in getattr(proxy, "TimestepValues", None) or []]
    proxy.UpdatePipeline(times[-1]) if times else proxy.UpdatePipeline()
    whole = proxy.GetDataInformation()
    points = proxy.PointData
    told[file] = {
        "dimensions": list(proxy.GetProperty("Dimensions").Available) if file.endswith(".nc") else [],
        "chosen": proxy.Dimensions[0] if file.endswith(".nc") else "",
        "times": times,
        "bounds": list(whole.GetBounds()),
        "points": whole.GetNumberOfPoints(),
        "arrays": {points.GetArray(n).Name: [points.GetArray(n).GetNumberOfComponents(), *points.GetArray(n).GetRange(0)]
                   for n in range(points.GetNumberOfArrays())},
    }
print("TOLD" + json.dumps(told))
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    program = os.environ.get("FUMON_PROGRAM")
    if not shutil.which("pvpython") or not program:
        pytest.skip("pvpython (python3-paraview) is not installed, or FUMON_PROGRAM names no program")
    folder = tmp_path_factory.mktemp("paraview")
    for name, scene in SCENES.items():
        (folder / f"{name}.toml").write_text(scene + RUN)
        subprocess.run([program, "run", f"{name}.toml", "-o", name, "-q"], cwd=folder, check=True)
    for what in ["dunes.pvd", "water.pvd", "airflow.pvd", *MESHES]:
        subprocess.run([program, "export", pathlib.Path(what).stem, "-o", what, "-q"], cwd=folder, check=True)
    (folder / "reader.py").write_text(READER)
    files = [*(f"{name}/fields.nc" for name in SCENES), "dunes.pvd", "water.pvd", "airflow.pvd", *MESHES]
    done = subprocess.run(["pvpython", "--force-offscreen-rendering", "reader.py", *files], cwd=folder, text=True, capture_output=True)
    assert done.returncode == 0 and not re.search("WARN|ERR", done.stdout + done.stderr), done.stdout + done.stderr
    return json.loads(done.stdout.split("TOLD")[1])


@pytest.mark.parametrize("name", SCENES)
def test_fields_open_flat_at_the_bed(told, name):
    seen = told[f"{name}/fields.nc"]
    assert seen["chosen"] == "(y, x)" in seen["dimensions"]
    columns, rows = {"sandpile": (21, 21), "airflow": (32, 1)}.get(name, (24, 16))
    west, east, south, north, low, high = seen["bounds"]
    assert seen["points"] == columns * rows and low == high == 0.0
    cell = 2.0 if name in ("dunes", "water", "static") else (east - west) / (columns - 1)
    assert east - west == pytest.approx(cell * (columns - 1)) and north - south == pytest.approx(cell * (rows - 1))
    assert len(seen["times"]) == 4 and seen["times"][0] == 0.0 and seen["times"] == sorted(set(seen["times"]))
    fields = {"dunes": {"sand", "rock", "wind_shadow"}, "sandpile": {"last_avalanche"}, "gully": {"water_depth", "velocity_x"},
              "water": {"water_depth", "velocity_y"}}
    assert {"bed_height", *fields.get(name, ())} <= set(seen["arrays"])


def test_sections_of_air_and_grains_are_further_grids(told):
    assert "(z, section_x)" in told["airflow/fields.nc"]["dimensions"]


def test_times_are_those_of_the_model(told):
    year = 365.242198781
    assert told["dunes/fields.nc"]["times"] == pytest.approx([year * time for time in told["dunes.pvd"]["times"]])
    for name in ("water", "airflow"):
        assert told[f"{name}/fields.nc"]["times"] == pytest.approx(told[f"{name}.pvd"]["times"])
    assert told["sand/fields.nc"]["times"] == [0.0, 2.0, 4.0, 6.0]


def test_series_have_heights_and_vectors(told):
    dunes, water, air = (told[f"{name}.pvd"] for name in ("dunes", "water", "airflow"))
    assert len(dunes["times"]) == len(water["times"]) == len(air["times"]) == 4
    assert dunes["bounds"][:4] == [1.0, 47.0, 1.0, 31.0] and dunes["bounds"][4:] == pytest.approx(dunes["arrays"]["bed_height"][1:])
    assert {"sand", "rock", "moving_sand"} <= set(dunes["arrays"])
    assert water["arrays"]["velocity"][0] == air["arrays"]["velocity"][0] == 3
    assert {"pressure", "vorticity"} <= set(air["arrays"])


def test_meshes_open(told):
    low, high = told["dunes.vts"]["bounds"][4:]
    for mesh in ("dunes.ply", "dunes.obj"):
        assert told[mesh]["bounds"] == pytest.approx([1.0, 47.0, 1.0, 31.0, low, high], rel=1e-5)
    assert "RGB" in told["dunes.ply"]["arrays"]
    glb, stl = told["dunes.glb"]["bounds"], told["dunes.stl"]["bounds"]
    assert [glb[1] - glb[0], glb[5] - glb[4], glb[3] - glb[2]] == pytest.approx([46.0, 30.0, high - low], rel=1e-5)  # y is up
    assert stl[1] - stl[0] == pytest.approx(150.0) and stl[4] == 0.0  # millimetres, on the table
