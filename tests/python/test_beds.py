"""Beds from memory: a scene starts from an array, is copied, pickled and swept with it, and says where it came from."""

import copy
import pickle
import subprocess
import os

import numpy as np
import pytest
import xarray

import fumon

TEXT = '[model]\nname = "static"\n[run]\nsteps = 1\n'
HERE = {"image_width": 96, "image_height": 64, "image_supersampling": 1}
y, x = np.mgrid[0:14, 0:20]
HILLS = 3.0 * np.sin(0.5 * x) + 2.0 * np.cos(0.4 * y) + 0.2 * x
X, Y = 500_000.0 + 2.0 * np.arange(20), 4_100_000.0 + 3.0 * np.arange(14)


def scene_of(bed, **more):
    return fumon.Scene.from_toml(TEXT, bed=bed, **HERE, **more)


def array(values=HILLS, **attributes):
    coordinates = {"y": ("y", Y, attributes), "x": ("x", X, attributes)}
    return xarray.DataArray(values, coordinates, ("y", "x"))


def test_a_scene_starts_from_an_array():
    step = scene_of(HILLS, cell_size=(2, 3)).at(0)
    assert np.array_equal(step.bed, HILLS) and step.cell_size == (2.0, 3.0) and step.nodata is None
    assert np.array_equal(step.image(), fumon.render(HILLS, (2, 3), **HERE))
    assert np.array_equal(scene_of(HILLS[::-1], origin="upper").at(0).bed, HILLS)
    assert scene_of(HILLS).at(0).cell_size is None
    assert scene_of(HILLS, grid_cell_size=[5.0]).at(0).cell_size == (5.0, 5.0)
    own = HILLS.copy()
    scene = scene_of(own)
    own[:] = 0
    assert np.array_equal(scene.at(0).bed, HILLS)


def test_a_model_runs_over_it():
    scene = fumon.Scene("terada-barchans", bed=np.round(np.abs(HILLS)) + 2, run_steps=3)
    before, after = (scene.at(step).bed for step in (0, 3))
    assert before.shape == (14, 20) and before.sum() == after.sum() and not np.array_equal(before, after)
    assert (scene["bed.kind"], scene["bed.file"][:7]) == ("file", "memory:")


def test_nan_and_masked_cells_lie_outside():
    holed = HILLS.copy()
    holed[3:6, 4:9] = np.nan
    for bed in (holed, np.ma.masked_invalid(holed), np.ma.array(HILLS, mask=np.isnan(holed))):
        step = scene_of(bed).at(0)
        assert np.array_equal(step.nodata.astype(bool), np.isnan(holed))
    filled = scene_of(holed, bed_nodata="fill").at(0)
    assert filled.nodata is None and np.isfinite(filled.bed).all()


def test_a_dataarray_brings_its_cells_and_its_north():
    for same in (array(), array().T, array()[::-1], array()[:, ::-1], array().expand_dims(band=1)):
        step = scene_of(same).at(0)
        assert np.array_equal(step.bed, HILLS) and step.cell_size == (2.0, 3.0)
    kilometres = array(units="km").assign_coords(x=("x", X / 1000, {"units": "km"}), y=("y", Y / 1000, {"units": "km"}))
    assert scene_of(kilometres).at(0).cell_size == pytest.approx((2.0, 3.0))
    assert scene_of(array(), cell_size=7).at(0).cell_size == (7.0, 7.0)
    feet = array()
    feet.attrs["units"] = "ft"
    assert scene_of(feet).at(0).bed == pytest.approx(0.3048 * HILLS)


def test_degrees_become_metres_and_the_user_hears_of_it():
    lon, lat = 7.0 + np.arange(20) / 3600, 46.0 - np.arange(14) / 3600
    degrees = xarray.DataArray(HILLS[::-1], {"lat": lat, "lon": lon}, ("lat", "lon"))
    with pytest.warns(UserWarning, match="degrees"):
        step = scene_of(degrees).at(0)
    assert step.cell_size == pytest.approx((21.52, 30.87), abs=0.02) and np.array_equal(step.bed, HILLS)


def test_its_place_and_reference_system_come_along():
    placed = array().assign_coords(spatial_ref=((), 0, {"crs_wkt": "EPSG:32613"}))
    with pytest.warns(UserWarning, match="EPSG|reference system|zone"):
        turned = scene_of(placed, bed_crs="EPSG:32612").at(0)  # the zone to the west: turned by some degrees
    assert np.isfinite(turned.bed).all() and turned.bed.shape != HILLS.shape
    with pytest.raises(fumon.InputError, match="the array"):
        scene_of(array(), bed_crs="EPSG:32612").at(0)
    with pytest.raises(fumon.InputError, match="EPSG:99999"):
        scene_of(array().assign_attrs(crs="EPSG:99999"))


@pytest.mark.parametrize("wrong, error, words", [
    (HILLS[0], ValueError, "array"),
    (np.full((4, 4), np.nan), ValueError, "no cell"),
    (np.where(HILLS > 4, np.inf, HILLS), ValueError, "infinite"),
    (xarray.Dataset({"z": (("y", "x"), HILLS)}), TypeError, "Dataset"),
    ("hills.asc", TypeError, "bed_file="),
])
def test_what_is_no_terrain_is_refused(wrong, error, words):
    with pytest.raises(error, match=words):
        scene_of(wrong)


def test_the_checks_are_those_of_files():
    with pytest.raises(fumon.InputError, match="the array: .*beyond|no ground"):
        scene_of(np.where(HILLS > 4, 2e6, HILLS)).at(0)
    with pytest.raises(fumon.InputError, match="grid.nx is 7, but the array has 20 cells"):
        scene_of(HILLS, grid_nx=7).at(0)
    with pytest.raises(fumon.InputError, match="the array has cells of"):
        scene_of(HILLS, cell_size=2, grid_cell_size=[5.0]).at(0)
    with pytest.raises(fumon.InputError, match="bed.window applies to files"):
        scene_of(HILLS, bed_window=[0, 0, 4, 4]).at(0)
    with pytest.raises(ValueError, match="cell_size, origin and field"):
        fumon.Scene.from_toml(TEXT, cell_size=3)
    with pytest.raises(TypeError, match="when it is made"):
        fumon.Scene.from_toml(TEXT)["bed"] = HILLS
    assert fumon.Scene.from_toml(TEXT, bed={"kind": "flat", "height": 2}).at(0).bed.max() == 2


@pytest.mark.parametrize("way", [copy.copy, copy.deepcopy, lambda scene: pickle.loads(pickle.dumps(scene)),
                                 lambda scene: scene.copy()])
def test_such_a_scene_is_copied(way):
    first = scene_of(array().assign_coords(spatial_ref=((), 0, {"crs_wkt": ""})))
    twin = way(first)
    assert dict(twin) == dict(first)
    del first
    assert np.array_equal(twin.at(0).bed, HILLS) and twin.at(0).cell_size == (2.0, 3.0)


def test_a_pickle_brings_the_heights_to_another_process(tmp_path, in_another):
    (tmp_path / "scene").write_bytes(pickle.dumps(scene_of(HILLS, cell_size=2)))
    code = f"import pickle; print(pickle.load(open({str(tmp_path / 'scene')!r}, 'rb')).at(0).bed.sum())"
    assert float(in_another(code)) == pytest.approx(HILLS.sum(), rel=1e-12)


def test_the_heights_alone_decide_the_name():
    name = scene_of(HILLS, cell_size=2)["bed.file"]
    assert name == scene_of(HILLS.copy(), cell_size=2, seed=5)["bed.file"]
    others = {scene_of(HILLS + 1e-12)["bed.file"], scene_of(HILLS)["bed.file"], scene_of(HILLS.T)["bed.file"],
              scene_of(array())["bed.file"], scene_of(np.where(HILLS > 5, np.nan, HILLS))["bed.file"], name}
    assert len(others) == 6


def test_a_sweep_starts_from_it_and_goes_on(tmp_path):
    scene = fumon.Scene("terada-barchans", bed=np.round(np.abs(HILLS)) + 2, run_steps=2)
    found = scene.sweep({"model.creep_rate": [0.1, 0.3]}, folder=tmp_path / "runs", progress=False)
    again = fumon.Scene("terada-barchans", bed=np.round(np.abs(HILLS)) + 2, run_steps=2).sweep(
        {"model.creep_rate": [0.1, 0.3]}, folder=tmp_path / "runs", progress=False)
    assert found.equals(again) and (found["mean_height"] == (np.round(np.abs(HILLS)) + 2).mean()).all()


def test_a_picture_says_that_its_bed_came_from_memory(tmp_path):
    scene = scene_of(HILLS, cell_size=2)
    scene.at(0).save(tmp_path / "still.png")
    sha = scene["bed.file"].partition(":")[2]
    assert sha.encode() in (tmp_path / "still.png").read_bytes()

    def again(*more):
        return subprocess.run([os.environ["FUMON_PROGRAM"], "again", "still.png", "-o", "again.png", *more], cwd=tmp_path,
                              text=True, capture_output=True)

    told = again()
    assert told.returncode == 2 and "an array in the memory of a program" in told.stderr and "--set bed.file=FILE" in told.stderr
    rows = "\n".join(" ".join(repr(float(z)) for z in row) for row in HILLS[::-1])
    (tmp_path / "h.asc").write_text(f"ncols 20\nnrows 14\nxllcorner 0\nyllcorner 0\ncellsize 2\n{rows}\n")
    assert again("--set", "bed.file=h.asc").returncode == 0
    assert np.array_equal(fumon.Image.open(tmp_path / "again.png"), fumon.Image.open(tmp_path / "still.png"))


def test_a_text_that_names_heights_that_are_gone_is_told_so():
    text = scene_of(HILLS).to_toml()
    with pytest.raises(fumon.InputError, match="array in the memory"):
        fumon.Scene.from_toml(text).at(0)
