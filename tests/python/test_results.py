"""Stored records of runs and of other models, opened, drawn and filmed; Datasets; films of running models."""

import signal

import numpy as np
import pytest

import fumon

xarray = pytest.importorskip("xarray")

SMALL = {"image_width": 160, "image_height": 120, "image_supersampling": 1}


def flood(records=3, upside_down=False):
    """A valley that fills: depth at (record, y, x) is .5·record west of x = 50 m, and none east of it."""
    y, x = np.arange(12) * 10.0, np.arange(16) * 10.0
    bed = np.abs(y[:, None] - 60.0) / 10.0 + 0.0 * x
    depth = np.zeros((records, 12, 16))
    depth[:, :, :5] = 0.5 * np.arange(records)[:, None, None]
    data = xarray.Dataset(
        {"zb": (("y", "x"), bed, {"units": "m"}), "h": (("time", "y", "x"), depth * 100.0, {"units": "cm"}),
         "u": (("time", "y", "x"), np.full_like(depth, 0.25), {"units": "m s-1"})},
        coords={"y": ("y", y, {"units": "m"}), "x": ("x", x, {"units": "m"}),
                "time": np.datetime64("2019-08-31T14:00", "ns") + np.arange(records) * np.timedelta64(30, "m")},
        attrs={"source": "SFINCS"})
    return data.isel(y=slice(None, None, -1)) if upside_down else data


def test_a_file_is_opened_as_a_run(tmp_path):
    file = tmp_path / "flood.nc"
    flood().to_netcdf(file)
    run = fumon.open(file, **SMALL)
    assert len(run) == 3 and run.time_unit == "min"
    assert list(run.times) == [0, 30, 60] and run.steps == [0, 1, 2]
    assert run.dates[1] == "2019-08-31 14:30 UTC"
    assert run.fields["depth"][:2] == ("h", "cm")
    assert "of SFINCS" in run.description
    last = run[-1]
    assert last.date == "2019-08-31 15:00 UTC" and last.time == 60
    assert last.fields["water_depth"][3, 2] == 1.0 and last.fields["water_depth"][3, 9] == 0.0
    assert last.bed[0, 0] == 6.0 and last.cell_size == (10.0, 10.0)
    assert last.measures["wet_share"] == 60 / 192 and last.measures["mean_depth"] == 60 / 192  # 60 cells of 192 under 1 m
    assert last.image().shape == (120, 160, 3)
    assert not np.array_equal(run[0].image(), last.image())
    assert [one.step for one in run[1:]] == [1, 2]
    run.still(tmp_path / "last.png")
    assert (tmp_path / "last.png").read_bytes()[1:4] == b"PNG"
    with pytest.raises(IndexError):
        run[3]
    with pytest.raises(fumon.InputError, match="has no map \"hh\""):
        fumon.open(file, fields={"depth": "hh"})


def test_a_run_of_fumon_is_opened(tmp_path):
    import os
    import subprocess
    program = os.environ.get("FUMON_PROGRAM", "fumon")
    subprocess.run([program, "run", "terada-ripples", "-o", str(tmp_path / "out"), "--quiet", "--set", "run.steps=4", "--set",
                    "output.fields_every=2", "--set", "output.frames=false", "--set", "output.movie=false", "--set", "grid.nx=40",
                    "--set", "grid.ny=40"], check=True)
    run = fumon.open(tmp_path / "out")
    assert run.steps == [0, 2, 4] and run.fields == {} and run.description == ""
    assert run[1].bed.shape == (40, 40)


@pytest.mark.parametrize("upside_down", [False, True])
def test_a_dataset_is_recognised_as_a_file_is(upside_down):
    run = flood(upside_down=upside_down).fumon.results()
    assert run.dates[2] == "2019-08-31 15:00 UTC"
    assert set(run.fields) == {"bed", "depth", "u"}
    last = run[2]
    assert last.fields["water_depth"][3, 2] == 1.0
    assert last.bed[0, 0] == 6.0 and last.bed[11, 0] == 5.0
    assert last.fields["velocity_x"][3, 2] == 0.25 and last.fields["velocity_x"][3, 9] == 0.0
    assert last.cell_size == (10.0, 10.0)


def test_times_need_not_have_the_name_of_their_dimension():
    data = flood()
    named = data.drop_vars("time").rename({"time": "record"}).assign_coords(t=("record", data["time"].values))
    run = named.fumon.results()
    assert list(run.times) == [0, 30, 60] and run.dates[2] == "2019-08-31 15:00 UTC"


def test_variables_of_a_dataset_are_named():
    data = flood().rename({"h": "wetness", "zb": "floor"})
    run = data.fumon.results(bed="floor", depth="wetness")
    assert run[1].fields["water_depth"][0, 0] == 0.5
    with pytest.raises(fumon.InputError, match="has no map \"flor\""):
        data.fumon.results(bed="flor")


@pytest.mark.parametrize("rows_fall", [False, True])
def test_a_turned_dataset_is_drawn_along_its_sides(rows_fall):
    data = flood().drop_vars(["x", "y"]).rename({"y": "n", "x": "m"})
    n, m = np.meshgrid(np.arange(12) * 10.0, np.arange(16) * 10.0, indexing="ij")
    data = data.assign_coords(x=(("n", "m"), 0.8 * m - 0.6 * n), y=(("n", "m"), 0.6 * m + 0.8 * n))
    data["u"].attrs["standard_name"] = "eastward_sea_water_velocity"
    data["v"] = (("time", "n", "m"), np.full((3, 12, 16), 1.0), {"units": "m s-1", "standard_name": "northward_sea_water_velocity"})
    run = (data.isel(n=slice(None, None, -1)) if rows_fall else data).fumon.results()
    assert run[2].bed[0, 0] == 6.0 and run[2].bed[11, 0] == 5.0
    assert run[2].cell_size == pytest.approx((10.0, 10.0))
    assert run[2].fields["velocity_x"][3, 2] == pytest.approx(0.8 * 0.25 + 0.6 * 1.0)
    assert run[2].fields["velocity_y"][3, 2] == pytest.approx(0.8 * 1.0 - 0.6 * 0.25)


def test_dask_computes_a_record_at_a_time():
    dask_array = pytest.importorskip("dask.array")
    computed = []

    def noted(block, block_info=None):
        if block_info is not None and len(block_info) > 0:
            computed.append(block_info[0]["chunk-location"][0])
        return block
    data = flood(5)
    lazy = dask_array.from_array(data["h"].values, chunks=(1, 12, 16)).map_blocks(noted, dtype=float)
    run = data.assign(h=(("time", "y", "x"), lazy, {"units": "cm"})).fumon.results()
    computed.clear()
    assert run[3].fields["water_depth"][0, 0] == 1.5
    assert computed == [3]


def test_movies_and_films_show_water(tmp_path):
    data = flood()
    movie = data.fumon.movie(tmp_path / "a.mp4", rate=5, **SMALL)
    assert (movie.frames, movie.width, movie.height) == (3, 160, 120)
    assert data.fumon.movie(tmp_path / "beds.mp4", rate=5, variable="h", cell_size=10, **SMALL).frames == 3
    with pytest.raises(TypeError, match="cell_size is of a movie of heights"):
        data.fumon.movie(tmp_path / "c.mp4", depth="h", cell_size=10)
    script = tmp_path / "film.toml"
    script.write_text('[film]\nwidth = 160\nheight = 120\nrate = 5\nsupersampling = 1\n'
                      '[[shot]]\nseconds = 1\nfrom = "start"\nto = "end"\nmove = "orbit"\nturn = 20\n')
    film = data.fumon.film(tmp_path / "b.mp4", script, film_settings={"film_rate": 4})
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    with pytest.raises(KeyboardInterrupt):  # Python's own again, once a film is made
        signal.raise_signal(signal.SIGINT)
    assert film.frames == 4 and film.file.stat().st_size > 1000
    data.fumon.still(tmp_path / "c.png", record=1, **SMALL)
    assert (tmp_path / "c.png").exists()


class Grid:
    """What of a RasterModelGrid of Landlab is used."""

    shape, dx, dy = (12, 16), 10.0, 10.0

    def __init__(self):
        values = flood()
        self.at_node = {"topographic__elevation": values["zb"].values.ravel(), "surface_water__depth": np.zeros(12 * 16)}


class HexGrid:
    """What of a HexModelGrid of Landlab is used: rows of nodes, every other one shifted by half of the spacing."""

    def __init__(self, rows=6, columns=7, spacing=10.0):
        nodes = [(spacing * (column + 0.5 * (row % 2)), spacing * 0.75 ** 0.5 * row) for row in range(rows) for column in range(columns)]
        self.x_of_node, self.y_of_node = np.array(nodes).T
        self.nodes_at_patch = []
        for row in range(rows - 1):
            for first in range(columns * row, columns * row + columns - 1):
                above = first + columns
                self.nodes_at_patch += ([(first, first + 1, above), (first + 1, above + 1, above)] if row % 2 == 0 else
                                        [(first, first + 1, above + 1), (first, above + 1, above)])
        self.at_node = {"topographic__elevation": 2.0 * self.x_of_node - self.y_of_node,
                        "surface_water__depth": np.zeros(rows * columns)}


def test_a_grid_of_hexagons_is_laid_on_cells(tmp_path):
    grid = HexGrid()
    bed = fumon.terrain.bed_of(grid)
    assert bed.cell_size == (5.0, 5.0)  # half the edge
    y, x = 5.0 * (np.arange(bed.heights.shape[0]) + 0.5), 5.0 * (np.arange(bed.heights.shape[1]) + 0.5)
    inside = bed.nodata == 0
    assert inside.mean() > 0.8 and not inside.all()  # every other row begins half a spacing further east
    assert np.abs(bed.heights - (2.0 * x - y[:, None]))[inside].max() < 1e-4  # a plane stays one
    assert fumon.terrain.bed_of(grid, 2.0).cell_size == (2.0, 2.0)
    with fumon.film(tmp_path / "hexagons.mp4", rate=5, time_unit="yr", **SMALL) as film:
        dry = film.add(grid, time=0.0)
        grid.at_node["surface_water__depth"][:] = 2.0
        assert np.abs(dry.astype(int) - film.add(grid, time=1.0)).mean() > 2
    other = HexGrid()
    del other.nodes_at_patch
    with pytest.raises(TypeError, match="nodes_at_patch"):
        fumon.render(other)


def test_a_variable_colours_the_ground(tmp_path):
    data = flood().assign(tau=(("time", "y", "x"), np.arange(3 * 12 * 16.0).reshape(3, 12, 16), {"units": "Pa"}))
    data.to_netcdf(tmp_path / "flood.nc")
    plain, run = fumon.open(tmp_path / "flood.nc", **SMALL), fumon.open(tmp_path / "flood.nc", colour="tau", **SMALL)
    assert "tau" not in plain[1].fields and run[1].fields["tau"][2, 3] == 192 + 2 * 16 + 3
    assert np.abs(run.image().astype(int) - plain.image()).mean() > 5
    assert np.array_equal(data.fumon.results(colour="tau", **SMALL)[1].fields["tau"], run[1].fields["tau"])
    assert np.array_equal(fumon.open(tmp_path / "flood.nc", look_colour_by="field", look_field="tau", look_palette="viridis",
                                     **SMALL).image(), run.image())
    with pytest.raises(fumon.InputError, match="did you mean \"tau\"?"):
        fumon.open(tmp_path / "flood.nc", colour="tua")
    with pytest.raises(ValueError, match="no map 'tua'"):
        data.fumon.results(colour="tua")
    for own, colour in (({"zb": "bed"}, "bed"), ({"h": "depth"}, "depth")):
        named = data.rename(own).fumon.results(colour=colour, **SMALL)[1].fields
        assert {"water_depth", colour} <= named.keys()  # a quantity's name is a variable's, too


def test_a_film_grows_with_a_running_model(tmp_path):
    grid = Grid()
    with fumon.film(tmp_path / "grown.mp4", rate=5, time_unit="s", **SMALL) as film:
        dry = film.add(grid, time=0.0)
        grid.at_node["surface_water__depth"][:] = 2.0
        wet = film.add(grid, time=60.0)
        bare = film.add(grid.at_node["topographic__elevation"].reshape(12, 16), cell_size=10, time=120.0)
        with pytest.raises(ValueError, match="the first state had no u"):
            film.add(grid, u=np.zeros((12, 16)))
    assert np.abs(dry.astype(int) - bare).mean() < 2
    assert dry.shape == (120, 160, 3)
    assert np.abs(dry.astype(int) - wet).mean() > 2
    assert (tmp_path / "grown.mp4").exists()
    grid.at_node["surface_water__depth"][:32] = 0.0  # the southern rows
    pictures = []
    for origin in ("lower", "upper"):  # of the grid's own rows, whatever it says
        with fumon.film(tmp_path / f"{origin}.mp4", rate=5, **SMALL) as film:
            pictures.append(film.add(grid, origin=origin))
            with pytest.raises(ValueError, match="no field 'h' at its nodes"):
                film.add(grid, fields={"depth": "h"})
    assert np.array_equal(*pictures)
    with pytest.raises(ValueError, match="needs a frame"):
        fumon.film(tmp_path / "none.mp4").finish()
