"""Anyone's terrain: types, strides, no data, axes, cell sizes; and what is refused."""

import types

import numpy as np
import pytest
import xarray

import fumon
from fumon.terrain import bed_of

LOOK = {"image_width": 96, "image_height": 64, "image_supersampling": 1}


def hills(ny=14, nx=20):
    y, x = np.mgrid[0:ny, 0:nx]
    return 3.0 * np.sin(0.5 * x) + 2.0 * np.cos(0.4 * y) + 0.2 * x


HILLS = hills()


@pytest.fixture(scope="module")
def picture():
    return fumon.render(HILLS, 2.0, **LOOK)


@pytest.mark.parametrize("dtype", ["f2", ">f4", "<f4", "f8", "longdouble", "i2", "u1", ">i8"])
def test_every_real_type_is_drawn_alike(dtype):
    whole = np.round(HILLS + 10)
    assert np.array_equal(bed_of(whole.astype(dtype)).heights, whole)


def test_strides_and_orders_do_not_matter(picture):
    wide = np.zeros((28, 60))
    wide[::2, ::3] = HILLS
    for same in (np.asfortranarray(HILLS), wide[::2, ::3], HILLS[::-1][::-1], HILLS.tolist()):
        assert np.array_equal(fumon.render(same, 2.0, **LOOK), picture)
    assert np.array_equal(fumon.render(HILLS[::-1], 2.0, origin="upper", **LOOK), picture)
    assert not np.array_equal(fumon.render(HILLS[::-1], 2.0, **LOOK), picture)
    assert np.array_equal(bed_of(HILLS).heights, HILLS)  # and HILLS is as it was
    assert np.array_equal(HILLS, hills())


def test_the_look_is_that_of_the_scenes_keys(picture):
    assert picture.shape == (64, 96, 3) and picture.dtype == np.uint8 and isinstance(picture, fumon.Image)
    turned = fumon.render(HILLS, 2.0, camera_azimuth=100, **LOOK)
    assert not np.array_equal(turned, picture)
    assert np.array_equal(fumon.render(HILLS, 2.0, **{"camera.azimuth": 100}, **LOOK), turned)
    with pytest.raises(fumon.InputError, match='did you mean "look.palette"'):
        fumon.render(HILLS, 2.0, look_pallete="viridis")
    with pytest.raises(fumon.InputError, match="unknown palette"):
        fumon.render(HILLS, 2.0, look_palette="nopalette")


def test_a_drape_lies_north_up_over_the_terrain():
    drape = np.zeros((30, 40, 4), np.uint8)
    drape[:15, :, 0] = 255  # the north is red,
    drape[15:, :, 2] = 255  # the south blue
    drape[:, 20:, 3] = 255  # and the west seen through
    look = {"camera_projection": "map", "camera_margin": 0.0, "look_drape_light": "as-it-is", **LOOK}
    flat = np.ones((30, 40))
    ground, draped = fumon.render(flat, 2.0, **look), fumon.render(flat, 2.0, drape=drape, **look)
    assert tuple(draped[16, 72]) == (255, 0, 0) and tuple(draped[48, 72]) == (0, 0, 255)
    assert np.abs(draped[32, 24].astype(int) - ground[32, 24]).max() <= 6
    with pytest.raises(TypeError, match="drape is an array of uint8, not float64"):
        fumon.render(flat, drape=np.zeros((3, 4, 3)))
    with pytest.raises(fumon.InputError, match="red, green and blue"):
        fumon.render(flat, drape=np.zeros((3, 4), np.uint8))


def test_layers_tell_where_each_pixel_looks(picture):
    y, x = np.mgrid[0:30, 0:40]
    layers = fumon.render_layers(x + 100.0, 10, camera_projection="map", image_width=80, image_height=60)
    heights, east = layers["field.height"], layers["position.X"]
    on = np.isfinite(heights)
    assert layers.units["position.X"] == "m" and on.mean() > 0.5
    assert np.abs(heights[on] - 100 - (east[on] / 10 - 0.5)).max() <= 0.51
    assert "120" not in repr(layers) and "80 x 60" in repr(layers)


def test_a_transparent_background_is_alpha(tmp_path, picture):
    block = fumon.render(HILLS, 2.0, look_background="transparent", **LOOK)
    assert block.shape == (64, 96, 4) and block.dtype == np.uint8
    assert (block[0, 0, 3], block[32, 48, 3]) == (0, 255)
    rows = "\n".join(" ".join(repr(float(z)) for z in row) for row in HILLS[::-1])
    (tmp_path / "t.asc").write_text(f"ncols 20\nnrows 14\nxllcorner 0\nyllcorner 0\ncellsize 2\n{rows}\n")
    (tmp_path / "t.toml").write_text('[model]\nname = "static"\n[bed]\nkind = "file"\nfile = "t.asc"\n')
    scene = fumon.Scene(tmp_path / "t.toml", look_background="transparent", **LOOK)
    scene.at(0).save(tmp_path / "still.png")
    assert np.array_equal(fumon.Image.open(tmp_path / "still.png"), block)  # as the program writes it
    block.save(tmp_path / "block.png")
    assert np.array_equal(fumon.Image.open(tmp_path / "block.png"), block)
    assert block._repr_png_().startswith(b"\x89PNG")
    assert fumon.compare(block, tmp_path / "block.png").likeness == "identical"
    assert fumon.compare(block, block[:, :, :3]).likeness != "identical"
    assert fumon.fingerprint(block)["pixels_sha256"] != fumon.fingerprint(block[:, :, :3])["pixels_sha256"]


def test_the_same_terrain_from_a_file_has_the_same_pixels(tmp_path):
    rows = "\n".join(" ".join(repr(float(z)) for z in row) for row in HILLS[::-1])
    (tmp_path / "t.asc").write_text(f"ncols 20\nnrows 14\nxllcorner 0\nyllcorner 0\ncellsize 2\n{rows}\n")
    (tmp_path / "t.toml").write_text('[model]\nname = "static"\n[bed]\nkind = "file"\nfile = "t.asc"\n')
    from_file = fumon.Scene(tmp_path / "t.toml", **LOOK).at(0).image()
    assert np.array_equal(fumon.render(HILLS, 2.0, **LOOK), from_file)


def test_nan_and_masked_cells_have_no_data(picture):
    holed = HILLS.copy()
    holed[3:6, 4:9] = np.nan
    drawn = fumon.render(holed, 2.0, **LOOK)
    assert not np.array_equal(drawn, picture)
    mask = np.isnan(holed)
    for filler in (1e30, np.inf, -9999.0):
        filled = np.where(mask, filler, HILLS)
        assert np.array_equal(fumon.render(np.ma.array(filled, mask=mask), 2.0, **LOOK), drawn)
        flipped = np.ma.array(filled[::-1], mask=mask[::-1])
        assert np.array_equal(fumon.render(flipped, 2.0, origin="upper", **LOOK), drawn)
    whole = np.ma.array(np.round(HILLS).astype(int), mask=mask)
    assert np.array_equal(bed_of(whole).nodata.astype(bool), mask)


@pytest.mark.parametrize("wrong, error, words", [
    (HILLS[0], ValueError, "array"),
    (np.zeros((4, 5, 3)), ValueError, "picture"),
    (np.zeros((0, 4)), ValueError, "cells"),
    (HILLS + 1j, TypeError, "real"),
    (HILLS > 0, TypeError, "real"),
    (np.array([["a", "b"], ["c", "d"]]), TypeError, "real"),
    (np.array([[1, None], [2, 3]], dtype=object), TypeError, "real"),
    (np.full((4, 4), np.nan), ValueError, "no cell"),
    (np.where(HILLS > 4, np.inf, HILLS), ValueError, "infinite"),
    (None, TypeError, "real"),
    (xarray.Dataset({"z": (("y", "x"), HILLS)}), TypeError, "Dataset"),
    (xarray.DataArray(np.zeros((2, 4, 5)), dims=("time", "y", "x")), ValueError, "isel"),
])
def test_what_is_no_terrain_is_refused(wrong, error, words):
    with pytest.raises(error, match=words):
        fumon.render(wrong, 2.0)


@pytest.mark.parametrize("size", [0, -1.0, float("nan"), float("inf"), (1, 2, 3), "x"])
def test_a_cell_size_is_a_length(size):
    with pytest.raises(ValueError):
        fumon.render(HILLS, size)


def array_with(x, y, values=HILLS, dims=("y", "x"), **attributes):
    coordinates = {dims[0]: (dims[0], y, attributes), dims[1]: (dims[1], x, attributes)}
    return xarray.DataArray(values, coordinates, dims)


X, Y = 500.0 + 2.0 * np.arange(20), 100.0 + 3.0 * np.arange(14)


def test_a_dataarray_brings_its_cell_size_and_axes():
    plain = fumon.render(HILLS, (2.0, 3.0), **LOOK)
    array = array_with(X, Y)
    for same in (array, array.transpose("x", "y"), array.isel(y=slice(None, None, -1)),
                 array.isel(x=slice(None, None, -1)), array.expand_dims(band=1), array.astype("f4").astype("f8") * 0 + array,
                 array.rename(y="northing", x="easting").T, array_with(X / 1000, Y / 1000, units="km")):
        bed = bed_of(same)
        assert np.array_equal(bed.heights, HILLS) and bed.cell_size == pytest.approx((2.0, 3.0))
    assert np.array_equal(array.T.fumon.render(**LOOK), plain)
    assert array.fumon.measure()["stoss_slope"] == fumon.measure(HILLS, (2.0, 3.0))["stoss_slope"]
    assert np.array_equal(array.fumon.render(5.0, **LOOK), fumon.render(HILLS, 5.0, **LOOK))
    bare = xarray.DataArray(HILLS, dims=("row", "column"))
    assert bed_of(bare).cell_size is None and np.array_equal(bed_of(bare).heights, HILLS)


def test_degrees_become_metres_at_the_middle_latitude():
    lon, lat = 7.0 + np.arange(20) / 3600, 46.0 - np.arange(14) / 3600
    bed = bed_of(array_with(lon, lat, values=HILLS[::-1], dims=("lat", "lon")))
    radius = 6371e3  # a sphere's lengths are within half a per cent
    dx, dy = np.radians(1 / 3600) * radius * np.cos(np.radians(lat.mean())), np.radians(1 / 3600) * radius
    assert bed.cell_size == pytest.approx((dx, dy), rel=5e-3)
    assert np.array_equal(bed.heights, HILLS)


def test_units_are_those_of_files():
    for unit, metres in (("ft", 0.3048), ("US survey foot", 1200 / 3937), ("km", 1000.0)):
        assert bed_of(array_with(X, Y, units=unit)).cell_size == pytest.approx((2.0 * metres, 3.0 * metres))
    array = array_with(X, Y)
    for attributes, factor in (({"units": "ft"}, 0.3048), ({"units": "cm"}, 0.01), ({"units": "m above sea level"}, 1.0),
                               ({"positive": "down"}, -1.0), ({"positive": "up"}, 1.0),
                               ({"standard_name": "sea_floor_depth_below_geoid", "units": "ft"}, -0.3048)):
        array.attrs = attributes
        assert np.allclose(bed_of(array).heights, factor * HILLS, rtol=1e-15), attributes
    array.attrs = {"units": "K"}
    with pytest.raises(ValueError, match="unit of length"):
        bed_of(array)


def test_longitudes_in_single_precision_are_even():
    lon = (-105.5 + np.arange(20) / 3600).astype(np.float32)
    lat = (40.0 + np.arange(14) / 3600).astype(np.float32)
    assert bed_of(array_with(lon, lat, dims=("lat", "lon"))).cell_size[1] == pytest.approx(30.8, abs=0.3)


def test_odd_coordinates_are_refused():
    with pytest.raises(ValueError, match="evenly"):
        array_with(X**2, Y).fumon.render()
    with pytest.raises(ValueError, match="'K'"):
        array_with(X, Y, units="K").fumon.render()
    sites = array_with(np.arange(20) + 0.5, np.arange(14) + 0.5, units="1")
    assert bed_of(sites).cell_size is None
    with pytest.raises(ValueError, match="north and east"):
        xarray.DataArray(np.zeros((2, 3, 4)), dims=("x", "a", "b")).fumon.render()


def test_a_grid_with_landlabs_attributes(picture):
    grid = types.SimpleNamespace(at_node={"topographic__elevation": HILLS.ravel(), "soil__depth": HILLS.ravel() / 2},
                                 shape=HILLS.shape, dx=2.0, dy=2.0)
    assert np.array_equal(fumon.render(grid, **LOOK), picture)
    assert fumon.measure(grid, field="soil__depth")["mean_height"] == pytest.approx(HILLS.mean() / 2)
    with pytest.raises(ValueError, match="field="):
        fumon.render(grid, field="sand")
    with pytest.raises(ValueError, match="Landlab"):
        fumon.render(HILLS, field="sand")


def test_measures_of_a_wave():
    x = np.arange(120)
    wave = 0.5 * np.sin(2 * np.pi * x / 20) * np.ones((60, 1))
    measures = fumon.measure(wave, 2.0, periodic=True)
    assert measures["wavelength_spectrum"] == pytest.approx(40, rel=1e-6)
    assert measures.units["wavelength_spectrum"] == "m"
    assert fumon.measure(wave, periodic=True)["wavelength_spectrum"] == pytest.approx(20, rel=1e-6)
    assert "wavelength_spectrum" in measures._repr_html_()
