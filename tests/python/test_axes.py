"""Views, maps and palettes in Matplotlib's axes: places are where the picture shows them, and colours are the palettes'."""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest
import xarray

import fumon

matplotlib = pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")
matplotlib.use("agg")
pyplot = pytest.importorskip("matplotlib.pyplot")

PALETTES = pathlib.Path(os.environ["FUMON_GUIDE"]).parent / "palettes"
y, x = np.mgrid[0:40, 0:60]
PLAIN = np.zeros((40, 60))
PLAIN[30, 45] = 40.0  # one tower of 10 m × 10 m

@pytest.fixture
def ax():
    figure, axes = pyplot.subplots(figsize=(4, 3), dpi=100)
    yield axes
    pyplot.close(figure)


def rendered(ax):
    """What Matplotlib draws, (rows, columns, 3), and where data coordinates are in it."""
    ax.figure.canvas.draw()
    pixels = np.asarray(ax.figure.canvas.buffer_rgba())[:, :, :3].astype(int)

    def at(x, y):
        column, row = ax.transData.transform((float(x), float(y)))
        return column, pixels.shape[0] - row

    return pixels, at


def test_a_map_fills_its_axes_with_the_beds_metres(ax):
    made = fumon.figure_axes(ax, PLAIN, 10, camera_projection="map", look_colour_by="height", look_palette="grey", look_shading=0,
                             look_exposure=0)
    assert made.extent == (0.0, 600.0, 0.0, 400.0) and made.unit == "m" and made.crs == ""
    assert ax.get_xlim() == (0, 600) and ax.get_ylim() == (0, 400)
    assert [float(one) for one in made.project(12, 34)] == [12, 34]
    pixels, at = rendered(ax)
    column, row = at(455, 305)  # the middle of the tower's cell
    inner = pixels[int(row), int(column)]
    for apart in (25, -25):
        for place in ((455 + apart, 305), (455, 305 + apart)):
            outside_column, outside_row = at(*place)
            outside = pixels[int(outside_row), int(outside_column)]
            assert np.abs(inner - outside).max() > 40


def test_a_map_of_placed_heights_has_their_coordinates(ax):
    placed = xarray.DataArray(PLAIN[::-1], {"y": 4.1e6 + 10.0 * np.arange(40)[::-1], "x": 5e5 + 10.0 * np.arange(60)}, ("y", "x"))
    made = fumon.figure_axes(ax, placed, camera_projection="map")
    assert made.extent == (499995.0, 500595.0, 4099995.0, 4100395.0) and ax.get_ylim() == (4099995.0, 4100395.0)


@pytest.mark.parametrize("projection", ["perspective", "orthographic"])
def test_places_are_projected_to_the_pixels_that_show_them(ax, projection):
    look = {"camera_projection": projection, "look_exaggeration": 2, "image_width": 300, "image_height": 200, "camera_azimuth": 160}
    hills = 20 * np.sin(x / 9) * np.cos(y / 7) + 100
    made = fumon.figure_axes(ax, hills, 10, **look)
    layers = fumon.render_layers(hills, 10, **look)
    east, north, height = (layers[f"position.{axis}"] for axis in "XYZ")
    on = np.isfinite(east) & (east > 5) & (east < 595) & (north > 5) & (north < 395) & (layers["normal.Z"] > 0.5)
    assert made.exaggeration == 2.0 and made.unit == "m" and on.mean() > 0.2
    across, down = made.project(east[on], north[on], height[on] / 2)
    rows, columns = np.nonzero(on)
    assert np.quantile(np.hypot(across - columns - 0.5, down - rows - 0.5), 0.99) < 0.7
    on_ground = np.hypot(*(a - b for a, b in zip(made.project(east[on], north[on]), (across, down))))
    assert np.median(on_ground) < 2.5  # without a height it is that of the cell

    pixels = np.asarray(made.image.get_array())
    assert pixels.shape == (200, 300, 4)
    rows, columns = np.nonzero(pixels[:, :, 3] > 128)  # the block alone
    corners = made.project([0, 600, 600, 0], [0, 0, 400, 400])[0]
    assert abs(corners.min() - columns.min()) <= 2 and abs(corners.max() - columns.max()) <= 2


def test_scenes_runs_and_steps_go_in(ax, barchans):
    barchans.update(image_supersampling=1)
    wide, tall = ax.get_window_extent().width / 100, ax.get_window_extent().height / 100
    made = fumon.figure_axes(ax, barchans, step=5, camera_projection="map", dots_per_inch=50)
    assert made.image.get_array().shape == (round(50 * tall), round(50 * wide), 3)
    assert made.unit == "sites" and made.extent == (0.0, 48.0, 0.0, 32.0)
    first = fumon.figure_axes(ax, barchans.run(at=[3]))
    assert first.project(0, 0)[0].shape == ()
    second = fumon.figure_axes(ax, barchans.at(3))
    assert np.array_equal(first.image.get_array(), second.image.get_array())
    assert np.allclose(first.project(10, 12), second.project(10, 12))


def test_what_does_not_fit_is_refused(ax, barchans):
    with pytest.raises(ValueError, match="as its scene says"):
        fumon.figure_axes(ax, barchans.at(1), camera_azimuth=3)
    with pytest.raises(ValueError, match="no steps"):
        fumon.figure_axes(ax, PLAIN, 10, step=3)
    with pytest.raises(ValueError, match="dots_per_inch"):
        fumon.figure_axes(ax, PLAIN, 10, dots_per_inch=0)
    with pytest.raises(fumon.InputError, match='did you mean "camera.azimuth"'):
        fumon.figure_axes(ax, PLAIN, 10, camera_azimut=3)


@pytest.mark.parametrize("name", sorted(file.stem for file in PALETTES.glob("*.txt")))
def test_palettes_are_colormaps(name):
    colours = np.loadtxt(PALETTES / f"{name}.txt", comments="#")
    made = fumon.colormap(name)
    assert made.N == 256 and np.array_equal(np.round(made(np.arange(256))[:, :3] * 255), colours)
    assert np.array_equal(matplotlib.colormaps[f"fumon.{name}"](np.arange(256)), made(np.arange(256)))
    assert np.array_equal(fumon.colormap(f"{name}_r")(0.0)[:3], made(1.0)[:3])


def test_an_unknown_palette_is_refused():
    with pytest.raises(fumon.InputError, match="palette"):
        fumon.colormap("batlo")


def test_matplotlib_is_not_loaded_before():
    code = "import fumon, sys; assert 'matplotlib' not in sys.modules"
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0
