"""Runs: which steps, views that stay, measures, and the same bytes as the program's."""

import csv
import gc
import json
import os
import subprocess

import numpy as np
import pytest

import fumon
from fumon.settings import settings_of

SITES = {"grid.nx": 48, "grid.ny": 32}
PROGRAM = os.environ["FUMON_PROGRAM"]


def test_steps_come_as_asked(barchans):
    assert [step.step for step in barchans.run(every=15)] == [0, 15, 30]
    assert [step.step for step in barchans.run(at=[40, 7, 7])] == [7, 40]
    barchans.update({"frames.at": [3, 11], "frames.every": 0})
    assert [step.step for step in barchans.run()] == [3, 11]
    assert barchans.at().step == 40
    run = barchans.run(every=40)
    next(run)
    assert run.steps_done == 0
    assert next(run).step == run.steps_done == 40
    with pytest.raises(StopIteration):
        next(run)


@pytest.mark.parametrize("wrong", [{"every": 0}, {"every": 5, "at": [3]}, {"at": [41]}, {"at": [-1]}, {"threads": -1}])
def test_wrong_steps_are_refused(barchans, wrong):
    with pytest.raises(ValueError):
        barchans.run(**wrong)


def test_a_bed_is_a_view_that_stays_and_cannot_be_written(barchans):
    run = barchans.run(every=20)
    first = next(run)
    bed = first.bed
    before = bed.copy()
    assert bed.shape == (32, 48) and bed.dtype == np.float64 and bed.flags.c_contiguous
    assert not bed.flags.owndata and not bed.flags.writeable
    assert first.bed.__array_interface__["data"] == bed.__array_interface__["data"]  # zero copies
    with pytest.raises(ValueError):
        bed[0, 0] = 1.0
    with pytest.raises(ValueError):
        bed.flags.writeable = True
    later = next(run)
    assert not np.array_equal(later.bed, before)
    del first, run
    gc.collect()
    assert np.array_equal(bed, before)


def test_fields_units_and_times_of_water():
    scene = fumon.Scene("dam-break", grid_nx=24, grid_ny=6, run_steps=4)
    step = scene.at(4)
    assert step.time_unit == "s" and 0 < step.time
    assert step.cell_size is not None and step.height_unit == 1.0
    depth = step.fields["water_depth"]
    assert depth.shape == step.bed.shape and depth.max() > 0 and not depth.flags.writeable
    unit, meaning = step.field_notes["water_depth"]
    assert unit == "m" and "depth" in meaning


def test_measures_are_those_of_the_program(barchans, tmp_path):
    (tmp_path / "s.toml").write_text(barchans.to_toml())
    subprocess.run([PROGRAM, "run", tmp_path / "s.toml", "-o", tmp_path / "out", "--quiet", "--set", "output.frames=false",
                    "--set", "output.movie=false", "--set", "output.measure_every=10"], check=True)
    rows = list(csv.DictReader((tmp_path / "out/measurements.csv").open()))
    run = barchans.run(every=10)
    for row, step in zip(rows, run, strict=True):
        measures = step.measures
        assert int(row["step"]) == step.step and float(row["time"]) == step.time
        for name, value in measures.items():
            assert row[name] == "" and np.isnan(value) or float(row[name]) == value, name
        assert set(row) == {"step", "time", *measures}
    assert measures.units["wavelength_spectrum"] == "sites" and measures.help["wavelength_spectrum"]
    manifest = json.loads((tmp_path / "out/run.json").read_text())
    assert run.state_hash in json.dumps(manifest)
    with pytest.raises(ValueError, match="measures=True"):
        next(barchans.run(every=10, measures=False)).measures


@pytest.mark.parametrize("name, step, settings", [
    ("terada-barchans", 40, SITES),
    ("terada-barchans", 0, {**SITES, "camera.turn": 90.0, "image.supersampling": 1}),
    ("sandpiles", 30, {"output.measure_every": 10,
                       "overlay": [{"kind": "plot", "y": "maximum_height"}]}),
    ("gully-rain", 2, {"look.colour_by": "water-depth"}),
    ("air-and-grains", 1, {}),
])
def test_pictures_are_the_programs_to_the_byte(tmp_path, name, step, settings):
    settings = {**settings, "run.steps": 40, "image.width": 192, "image.height": 108}
    words = [f"--set={key}={value}" for key, value in settings_of(settings)]
    subprocess.run([PROGRAM, "still", name, "--step", str(step), "-o", tmp_path / "program.png", "--quiet", *words],
                   check=True)
    present = fumon.Scene(name, **settings).at(step)
    present.save(tmp_path / "module.png")
    assert (tmp_path / "module.png").read_bytes() == (tmp_path / "program.png").read_bytes()
    assert np.array_equal(present.image(), fumon.Image.open(tmp_path / "program.png"))


def test_layers_are_the_programs_to_the_byte(tmp_path):
    settings = {**SITES, "run.steps": 20, "image.width": 96, "image.height": 54, "camera.elevation": 3}
    words = [f"--set={key}={value}" for key, value in settings_of(settings)]
    subprocess.run([PROGRAM, "still", "terada-barchans", "--step", "20", "-o", tmp_path / "program.exr", "--quiet",
                    *words], check=True)
    present = fumon.Scene("terada-barchans", **settings).at(20)
    present.save(tmp_path / "module.exr")
    assert (tmp_path / "module.exr").read_bytes() == (tmp_path / "program.exr").read_bytes()
    layers = present.layers()
    assert layers.light.shape == (54, 96, 3) and layers.light.dtype == np.float32
    seen = np.isfinite(layers["Z"])
    assert 0.1 < seen.mean() < 1.0 and layers.units["Z"] == "sites"
    lengths = sum(layers[f"normal.{axis}"] ** 2 for axis in "XYZ")
    assert np.allclose(lengths[seen], 1, atol=0.01)
    assert np.nanmax(layers["field.height"]) <= present.bed.max()
    assert present.image().shape == (54, 96, 3)  # the two are drawn in turn
    assert np.array_equal(present.layers()["R"], layers["R"])


def test_the_flat_figure_of_a_section_has_no_layers():
    section = fumon.Scene("air-and-grains", look_mode="figure", run_steps=1, image_width=96, image_height=54).at(1)
    with pytest.raises(fumon.InputError, match="look.mode"):
        section.layers()


def test_the_bed_is_that_of_the_program(barchans, tmp_path):
    (tmp_path / "s.toml").write_text(barchans.to_toml())
    subprocess.run([PROGRAM, "run", tmp_path / "s.toml", "-o", tmp_path / "out", "--quiet", "--set", "output.frames=false",
                    "--set", "output.movie=false", "--set", "output.fields_every=20"], check=True)
    xarray = pytest.importorskip("xarray")
    with xarray.open_dataset(tmp_path / "out/fields.nc") as fields:
        for index, step in enumerate(barchans.run(every=20)):
            assert np.array_equal(fields["bed_height"].isel(date=index).values, step.bed)


def test_a_picture_after_later_steps_is_the_same(barchans):
    run = barchans.run(every=20)
    first = next(run)
    at_once = first.image()
    for _ in run:
        pass
    assert np.array_equal(first.image(), at_once)


def test_any_number_of_threads_gives_the_same_state(barchans):
    hashes = set()
    for threads in (1, 3):
        run = barchans.run(at=[40], threads=threads)
        next(run)
        hashes.add(run.state_hash)
    assert len(hashes) == 1
