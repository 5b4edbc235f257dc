"""Sweeps as Datasets."""

import csv
import os
import subprocess

import numpy as np
import pytest

import fumon

PROGRAM = os.environ["FUMON_PROGRAM"]


def test_a_sweep_is_the_programs_table(barchans, tmp_path):
    (tmp_path / "s.toml").write_text(barchans.to_toml())
    subprocess.run([PROGRAM, "sweep", tmp_path / "s.toml", "-o", tmp_path / "out", "--quiet", "--over",
                    "model.creep_rate=0.1,0.3", "--seeds", "2:3", "--set", "output.measure_every=20"], check=True)
    barchans["output.measure_every"] = 20
    found = barchans.sweep({"model_creep_rate": [0.1, 0.3]}, seeds=range(2, 4))
    assert dict(found.sizes) == {"model_creep_rate": 2, "seed": 2, "step": 3}
    rows = list(csv.DictReader((tmp_path / "out/sweep.csv").open()))
    assert len(rows) == 12
    for row in rows:
        here = found.sel(model_creep_rate=float(row["model.creep_rate"]), seed=int(row["seed"]), step=int(row["step"]))
        for name in set(found.data_vars) - {"state_sha256"}:
            value = float(here[name])
            assert row[name] == "" and np.isnan(value) or float(row[name]) == value, name
    runs = list(csv.DictReader((tmp_path / "out/runs.csv").open()))
    assert sorted(row["state_sha256"] for row in runs) == sorted(found["state_sha256"].values.ravel())
    spectrum = found["wavelength_spectrum"]
    assert spectrum.attrs["units"] == "sites" and spectrum.attrs["long_name"]
    assert found["time"].attrs["units"] == "steps"


def test_keys_that_go_together_and_folders_that_are_gone_on_with(barchans, tmp_path):
    over = {("grid.nx", "grid.ny"): [16, 24], "model.landing": ["truncate", "round"]}
    found = barchans.sweep(over, folder=tmp_path / "sweep")
    assert found.sizes["grid.nx"] == 2 and list(found["model.landing"].values) == ["truncate", "round"]
    assert (tmp_path / "sweep/sweep.csv").is_file()
    records = {file: file.stat().st_mtime_ns for file in (tmp_path / "sweep/runs").iterdir()}
    again = barchans.sweep(over, folder=tmp_path / "sweep", progress=True)
    assert again.identical(found)
    assert all(file.stat().st_mtime_ns == then for file, then in records.items())


def test_a_scenes_own_sweep(barchans):
    barchans["sweep.over"] = ["model.creep_rate=0.1:0.2:2"]
    barchans["sweep.seeds"] = 3
    found = barchans.sweep()
    assert list(found["model.creep_rate"].values) == [0.1, 0.2] and found.sizes["seed"] == 3


def test_wrong_sweeps(barchans):
    with pytest.raises(fumon.InputError, match="model.creep_rate is 7"):
        barchans.sweep({"model.creep_rate": [0.1, 7]})
    with pytest.raises(fumon.InputError, match="did you mean"):
        barchans.sweep({"model.creep_rat": [0.1]})
    with pytest.raises(ValueError):
        barchans.sweep({"model.creep_rate": []})
    with pytest.raises(ValueError):
        barchans.sweep(seeds=range(1, 10, 2))
