"""Scenes: keys read and set, and what is said of wrong ones."""

import pathlib

import numpy as np
import pytest

import fumon

TEXT = """
[model]
name = "sand"
[run]
steps = 20
[grid]
nx = 16
ny = 8
"""


def test_keywords_are_keys_with_an_underscore_for_the_dot():
    scene = fumon.Scene("terada-barchans", seed=5, model_creep_rate=0.25, **{"camera.azimuth": 160})
    assert (scene["seed"], scene["model.creep_rate"], scene["camera.azimuth"]) == (5, 0.25, 160.0)
    assert scene["camera_azimuth"] == 160.0


def test_no_section_has_an_underscore_in_its_name():
    for name in ("terada-barchans", "gully-rain", "sandpiles", "air-and-grains", "dunes-barchans"):
        assert not [key for key in fumon.Scene(name) if "_" in key.split(".")[0]]


def test_every_kind_of_value_is_read_and_set():
    scene = fumon.Scene.from_toml(TEXT)
    values = {"title": 'a "b" \\ é', "seed": 7, "output.movie": False, "look.exposure": -0.5, "frames.at": [0, 5],
              "grid.cell_size": [2.0], "look.palette": "viridis", "look.low": 1.5, "output.bed_format": ["esri-ascii"],
              "camera.projection": "map"}
    scene.update(values)
    assert {key: scene[key] for key in values} == values
    scene["look.low"] = "auto"
    assert scene["look.low"] == "auto"
    scene["seed"] = np.int32(3)
    scene["frames.at"] = np.array([1, 2])
    scene["look.exposure"] = np.float32(0.25)
    assert (scene["seed"], scene["frames.at"], scene["look.exposure"]) == (3, [1, 2], 0.25)


def test_a_scene_is_a_mapping():
    scene = fumon.Scene.from_toml(TEXT)
    assert "run.steps" in scene and "run.stepz" not in scene and 3 not in scene
    assert len(scene) == len(list(scene)) > 80
    assert dict(scene)["run.steps"] == 20 and scene.get("no.key") is None
    other = scene.copy()
    assert other == scene
    other["seed"] = 9
    assert other != scene and scene["seed"] == 1
    assert fumon.Scene.from_toml(other.to_toml()) == other


def test_lists_of_sections_are_lists_of_dicts():
    scene = fumon.Scene.from_toml(TEXT, overlay=[{"kind": "scale-bar", "corner": "upper-left"}], grid_cell_size=[1.0])
    assert (scene["overlay.0.kind"], scene["overlay.0.corner"]) == ("scale-bar", "upper-left")


def test_wrong_values_say_what_would_be_right_and_change_nothing():
    scene = fumon.Scene.from_toml(TEXT)
    with pytest.raises(fumon.InputError, match="model.creep_rate is 7; it takes a number > 0"):
        scene["model.creep_rate"] = 7
    with pytest.raises(ValueError, match='did you mean "model.creep_rate"'):
        scene["model.creep_rat"] = 0.3
    with pytest.raises(fumon.InputError):
        scene.update(seed=4, run_steps="many")
    assert scene == fumon.Scene.from_toml(TEXT)
    with pytest.raises(TypeError, match="run.steps takes a number"):
        scene["run.steps"] = object()
    with pytest.raises(KeyError, match="run.steps"):
        scene["run.step"]


def test_a_wrong_file_is_told_with_line_and_column(tmp_path):
    file = tmp_path / "wrong.toml"
    file.write_text(TEXT + "ly = 3\n[look]\npalette = 5\n")
    with pytest.raises(fumon.Error, match=r"wrong.toml:9:1: .*grid.ly(.|\n)*wrong.toml:11:11: "):
        fumon.Scene(file)
    with pytest.raises(fumon.InputError, match='did you mean "terada-barchans"'):
        fumon.Scene("terada-barchan")
    with pytest.raises(TypeError):
        fumon.Scene(5)


def test_files_that_python_names_are_seen_from_the_working_folder(tmp_path, monkeypatch):
    (tmp_path / "scenes").mkdir()
    (tmp_path / "scenes" / "a.toml").write_text('[model]\nname = "static"\n')
    (tmp_path / "bed.asc").write_text("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n")
    monkeypatch.chdir(tmp_path)
    scene = fumon.Scene(pathlib.Path("scenes/a.toml"), bed_kind="file", bed_file=pathlib.Path("bed.asc"))
    step = scene.at(0)
    assert step.bed.tolist() == [[3.0, 4.0], [1.0, 2.0]]  # the file's last row is the southernmost
    assert step.cell_size == (1.0, 1.0)
