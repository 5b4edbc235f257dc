"""Lines, points and areas given to Python: in which forms, in which reference systems; and what is refused."""

import json
import pathlib
import urllib.request

import numpy as np
import pytest
import xarray

import fumon

FLAT = np.zeros((20, 30))
MAP = {"image_width": 120, "image_height": 80, "image_supersampling": 1, "camera_projection": "map", "camera_margin": 0.0}
RED = {"colour": "#ff0000", "width": 8.0}


class Frame:
    """A GeoDataFrame to fumon."""

    def __init__(self, geometry, crs=None):
        self.__geo_interface__ = {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"rank": np.int64(3)}, "geometry": geometry}]}
        self.crs = crs


def line(*points):
    return {"type": "LineString", "coordinates": points}


def frames_of(file):
    """The parts of an APNG that hold its pixels."""
    return pathlib.Path(file).read_bytes().split(b"IDAT")[1:]


def is_red(picture, row, column):
    return tuple(picture[row, column]) == (255, 0, 0)


def test_a_layer_is_a_file_features_or_keys(tmp_path):
    across = line((0, 10), (60, 10))  # metres from the south-western corner
    file = tmp_path / "across.geojson"
    file.write_text(json.dumps(across))
    expected = fumon.render(FLAT, 2.0, layer=[{"file": file, **RED}], **MAP)
    assert is_red(expected, 59, 60) and not is_red(expected, 40, 60)
    for features in (file, str(file), across, Frame(across), {"type": "Feature", "properties": {}, "geometry": across}):
        assert np.array_equal(fumon.render(FLAT, 2.0, layers=[{"file": features, **RED}], **MAP), expected)
    plain = fumon.render(FLAT, 2.0, layers=across, **MAP)
    assert np.array_equal(fumon.render(FLAT, 2.0, layers=[Frame(across)], **MAP), plain)
    assert not np.array_equal(plain, fumon.render(FLAT, 2.0, **MAP))
    scene = fumon.Scene("terada-barchans", layers=[across, {"data": "contours", "width": 1}])
    assert scene["layer.1.data"] == "contours" and scene["layer.0.file"].endswith(".geojson")


def test_movies_films_windows_and_axes_take_layers(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    layers = [{"file": line((0, 10), (60, 10)), **RED}]
    drawn = fumon.render(FLAT, 2.0, layers=layers, **MAP)
    fumon.movie([FLAT, FLAT], "movie.apng", cell_size=2.0, layers=layers, quality=0, **MAP)
    fumon.movie([drawn, drawn], "drawn.apng", quality=0)
    fumon.movie([FLAT, FLAT], "plain.apng", cell_size=2.0, quality=0, **MAP)
    assert frames_of("movie.apng") == frames_of("drawn.apng") != frames_of("plain.apng")
    with fumon.film("film.mp4", layers=layers, **MAP) as film:
        assert is_red(film.add(FLAT, cell_size=2.0), 59, 60)
    stack = xarray.Dataset({"zb": (("time", "y", "x"), np.stack([FLAT, FLAT]), {"units": "m"})},
                           {"x": 2.0 * np.arange(30), "y": 2.0 * np.arange(20), "time": [0, 1]})
    stack.to_netcdf("stack.nc")
    for run in (fumon.open("stack.nc", layers=layers, **MAP), stack.fumon.results(layers=layers, **MAP)):
        assert is_red(run.image(), 59, 60)
    with fumon.view(FLAT, 2.0, layers=layers, **MAP) as view:
        with urllib.request.urlopen(view.url) as page:
            assert page.status == 200


def test_axes_of_matplotlib_take_layers():
    axes = pytest.importorskip("matplotlib.figure").Figure(figsize=(1, 1)).add_subplot()
    with pytest.warns(UserWarning, match="the bed has no place"):
        fumon.figure_axes(axes, FLAT, 2.0, layers=[{"file": line((0, 10), (60, 10)), **RED}], camera_projection="map")
    picture = axes.images[0].get_array()
    assert np.any(np.all(picture[..., :3] == (255, 0, 0), axis=-1))


def test_layers_are_brought_to_the_reference_system_of_the_heights():
    east, north = 500_000 + 10.0 * np.arange(-14.5, 15), 4_427_757 + 10.0 * np.arange(-9.5, 10)
    heights = xarray.DataArray(FLAT, coords={"y": north, "x": east}, dims=("y", "x"), attrs={"crs": "EPSG:32613"})
    meridian = line((-105, 39.99), (-105, 40.01))  # the middle of the zone: easting 500 km
    for system in ("EPSG:4326", "OGC:CRS84", "WGS84"):
        drawn = fumon.render(heights, layers={"file": Frame(meridian, system), **RED}, **MAP)
        assert is_red(drawn, 40, 60) and not is_red(drawn, 40, 45)
    own = line((499_900, 4_427_757), (500_100, 4_427_757))
    assert is_red(heights.fumon.render(layers={"file": Frame(own, "EPSG:32613"), **RED}, **MAP), 40, 40)
    with pytest.raises(fumon.InputError, match="lies beside the bed"):
        fumon.render(heights, layers=Frame(own, "EPSG:32614"), **MAP)
    with pytest.raises(fumon.InputError, match="has no reference system, or a wrong one: .* reach 499900; name"):
        fumon.render(heights, layers=Frame(own), **MAP)
    for system in ("nonsense", ""):
        with pytest.raises(ValueError, match=f"the layer's crs '{system}' is no reference system"):
            fumon.render(heights, layers=Frame(own, system), **MAP)


def test_what_is_no_layer_is_refused():
    for wrong in ([3.0], [{"file": 3}], [None], None, 3):
        with pytest.raises(TypeError, match="a layer is a file, features"):
            fumon.render(FLAT, layers=wrong)
    with pytest.raises(fumon.InputError, match='did you mean "layer.0.colour"'):
        fumon.render(FLAT, layers={"file": line((0, 0), (1, 1)), "color": "#ff0000"})
