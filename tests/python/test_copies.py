"""Scenes and results that are copied and pickled: equal, and nothing is shared."""

import copy
import json
import os
import pickle
import subprocess

import numpy as np
import pytest

import fumon


def by_pickle(thing):
    return pickle.loads(pickle.dumps(thing))


WAYS = [copy.copy, copy.deepcopy, by_pickle, lambda thing: thing.copy()]


@pytest.mark.parametrize("way", WAYS)
def test_a_scene_is_copied(barchans, way):
    barchans["model.creep_rate"] = 0.3
    twin = way(barchans)
    assert type(twin) is fumon.Scene and dict(twin) == dict(barchans) and repr(twin) == repr(barchans)
    twin["seed"] = barchans["seed"] + 1
    barchans["model.creep_rate"] = 0.2
    assert (twin["model.creep_rate"], barchans["seed"]) == (0.3, twin["seed"] - 1)
    twin.update({"seed": barchans["seed"], "model.creep_rate": 0.2})
    assert np.array_equal(twin.at(5).bed, barchans.at(5).bed)


@pytest.mark.parametrize("way", WAYS)
def test_a_scene_of_a_text_and_a_kind_of_its_own(way):
    class Named(fumon.Scene):
        pass

    globals()["Named"] = Named
    Named.__qualname__ = "Named"
    scene = Named.from_toml('[model]\nname = "static"\n[grid]\nnx = 4\nny = 3\n[run]\nsteps = 1\n')
    scene.notes = ["mine"]
    twin = way(scene)
    assert type(twin) is Named and twin.to_toml() == scene.to_toml() and twin.notes == ["mine"]
    assert (twin.notes is scene.notes) == (way not in (copy.deepcopy, by_pickle))  # as Python copies attributes


def test_a_pickled_scene_finds_its_files_from_another_folder(tmp_path, monkeypatch):
    (tmp_path / "hill.asc").write_text("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n1 2\n3 4\n")
    (tmp_path / "hill.toml").write_text('[model]\nname = "static"\n[bed]\nkind = "file"\nfile = "hill.asc"\n[run]\nsteps = 1\n')
    monkeypatch.chdir(tmp_path)
    sent = pickle.dumps(fumon.Scene("hill.toml"))
    (tmp_path / "below").mkdir()
    monkeypatch.chdir(tmp_path / "below")
    assert pickle.loads(sent).at(0).bed.tolist() == [[3, 4], [1, 2]]


def test_results_are_copied(barchans):
    step = barchans.at(5)
    for way in (copy.copy, copy.deepcopy, by_pickle):
        image, twin = step.image(), way(step.image())
        assert type(twin) is fumon.Image and twin.environment == image.environment != ""
        assert np.array_equal(twin, image) and not np.shares_memory(twin, image)
        measures = way(step.measures)
        assert type(measures) is fumon.Measures and repr(measures) == repr(step.measures)
        assert (measures.units, measures.help) == (step.measures.units, step.measures.help)
        assert way(fumon.compare(image, twin)).likeness == "identical"
        layers = way(step.layers())
        assert layers.units == step.layers().units and np.array_equal(layers.light, step.layers().light)
    assert np.array_equal(by_pickle(step.bed), step.bed)


def test_what_is_under_way_says_what_to_send(barchans):
    run = barchans.run(every=10)
    for thing, words in ((run, "its Scene"), (next(run), "its bed"), (fumon.Bmi(), "initialize another")):
        for way in (copy.copy, copy.deepcopy, by_pickle):
            with pytest.raises(TypeError, match=words):
                way(thing)


def test_numbers_are_plain(barchans):
    image = barchans.at(0).image()
    assert type(image.mean()) is np.float64 and type(image.max()) is np.uint8 and type(image[0, 0, 0]) is np.uint8
    assert type(np.max(image)) is np.uint8 and type(image.sum()) is np.uint64
    assert type(image[:20]) is fumon.Image and image.mean(axis=2).shape == image.shape[:2]
    step = barchans.at(5)
    assert all(type(value) is float for value in step.measures.values()) and type(step.time) is float
    assert type(step.step) is int and type(barchans["model.creep_rate"]) is float and type(barchans["seed"]) is int
    told = fumon.compare(image, image)
    assert type(told.changed) is int and type(told.mean) is float


def test_a_picture_reckons_as_an_array_does():
    pixels = np.random.default_rng(0).integers(0, 255, (6, 8, 3), dtype=np.uint8)
    image = fumon.Image(pixels.copy())
    for of in (np.mean, np.median, np.std, np.ptp, np.argmax, np.average, np.nanmax, np.count_nonzero, lambda a: np.percentile(a, 30),
               lambda a: np.linalg.norm(a[0]), lambda a: np.dot(a[0, 0], a[0, 0]), lambda a: np.maximum.reduce(a, axis=None),
               lambda a: np.mean(a, where=a > 9), lambda a: np.divmod(a[0, 0].sum(), 3), lambda a: np.allclose(a, a)):
        assert type(of(image)) is type(of(pixels)) and of(image) == of(pixels)
    assert np.squeeze(image[:1, :1, :1]).shape == () and type(image / 255) is fumon.Image
    filled = np.empty(image.shape)
    assert np.add(image, 1, out=filled) is filled and np.array_equal(filled, pixels + 1.0)
    rest = np.empty_like(pixels)
    quotient, own = np.divmod(image, 3, out=(None, rest))
    assert type(quotient) is fumon.Image and own is rest and np.array_equal(rest, pixels % 3)
    image += 1
    assert type(image) is fumon.Image and np.array_equal(image, pixels + 1)
    assert type(np.ma.masked_greater(image, 30).mean()) is np.float64
    assert type(np.modf(image)) is tuple and type(np.modf(image)[0]) is fumon.Image


def test_a_bed_is_periodic_as_for_the_command(tmp_path):
    program = os.environ.get("FUMON_PROGRAM")
    if not program:
        pytest.skip("FUMON_PROGRAM names no program")
    bed = np.random.default_rng(3).normal(size=(12, 16))
    file = tmp_path / "bed.asc"
    file.write_text("ncols 16\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 2\n"
                    + "\n".join(" ".join(map(repr, map(float, row))) for row in bed[::-1]))
    for options, periodic in ([], {}), (["--open"], {"periodic": False}):
        told = subprocess.run([program, "measure", file, "--json", *options], capture_output=True, text=True, check=True)
        text = json.dumps(json.loads(told.stdout))
        for name in ("stoss_slope", "lee_slope"):
            assert repr(fumon.measure(bed, 2.0, **periodic)[name])[:8] in text, name
