"""Slope, aspect, shaded relief, drained area and wetness of arrays and of xarray's."""

import numpy as np
import pytest
import xarray

import fumon

Y, X = np.mgrid[0:12, 0:16]


def test_a_plane_has_its_slope_and_aspect():
    plane = 0.3 * 5.0 * X  # rises eastward
    assert fumon.raster(plane, "slope", 5) == pytest.approx(np.full((12, 16), np.degrees(np.arctan(0.3))))
    assert fumon.raster(plane, "aspect", 5) == pytest.approx(np.full((12, 16), 270.0))
    north = fumon.raster(0.3 * 4.0 * Y, "aspect", (5, 4))
    assert north == pytest.approx(np.full((12, 16), 180.0))
    assert fumon.raster(0.3 * 4.0 * Y, "aspect", (5, 4), origin="upper") == pytest.approx(np.full((12, 16), 0.0))


def test_level_ground_faces_nowhere_and_holes_stay():
    heights = np.full((12, 16), 2.0)
    heights[3, 4] = np.nan
    assert np.isnan(fumon.raster(heights, "aspect", 5)).all()
    slope = fumon.raster(heights, "slope", 5)
    assert np.isnan(slope[3, 4]) and np.isnan(slope).sum() == 1 and np.nanmax(slope) == 0
    assert np.isnan(fumon.raster(heights, "drainage", 5, origin="upper")[3, 4])


def test_the_light_and_the_area_are_those_asked_for():
    level = np.zeros((12, 16))
    assert fumon.raster(level, "hillshade", 5, sun_elevation=30)[5, 5] == pytest.approx(128)
    plane = np.asarray(1.0 * X)
    assert fumon.raster(plane, "drainage", 5)[5, 1] == 25.0 * 14  # the edges are outlets
    wet = fumon.raster(plane, "wetness", 5)[5, 1]
    assert wet == pytest.approx(np.log(25.0 * 14 / 5 / 0.2))


def test_dataarrays_keep_their_coordinates():
    heights = np.asarray(X * X + 3.0 * Y)
    array = xarray.DataArray(heights, coords={"y": 5.0 * Y[:, 0], "x": 5.0 * X[0]}, dims=("y", "x"), name="z")
    slope = array.fumon.raster("slope")
    assert slope.attrs["units"] == "degree" and slope.name == "slope"
    turned = array[::-1, ::-1].fumon.raster("slope")
    assert np.array_equal(turned.sortby("y").sortby("x").values, slope.values)
    assert np.array_equal(slope.values, fumon.raster(heights, "slope", 5))


def test_what_is_no_quantity_is_refused():
    with pytest.raises(fumon.InputError, match='"slop" is not a field; there are height, slope, aspect, hillshade'):
        fumon.raster(np.zeros((4, 4)), "slop")
    with pytest.raises(ValueError, match="are numbers"):
        fumon.raster(np.zeros((4, 4)), "hillshade", sun_azimuth=float("nan"))
