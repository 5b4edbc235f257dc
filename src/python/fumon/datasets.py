"""An xarray.Dataset as a run, and a film that grows with a running model."""

from __future__ import annotations

import json
import math
from types import TracebackType
from typing import Any, Callable, Mapping

import numpy as np

from . import _core
from .arrays import Heights, Numbers
from .images import Image, PathLike
from .movies import Movie
from .results import Results, results_of
from .settings import Setting, look_settings, settings_of
from .terrain import CellSize, Origin, bed_of, cells_of_coordinates, is_landlab, ordered_dims, sides_of_coordinates

_Quantities = Mapping[str, "str | None"]
_attributes = ("source", "title", "model", "program", "Producer", "history", "institution", "Conventions")


def results_of_dataset(dataset: Any, named: _Quantities, look: Mapping[str, Setting], name: str = "Dataset",
                       colour: str | None = None) -> Results:
    """The run that a Dataset holds, with its variables recognised as those of a file. Values are computed a record at a time."""
    along = _dimension_of_records(dataset)
    maps = {str(key): values for key, values in dataset.data_vars.items() if _is_map(values, along)}
    described = [_described(key, values, along) for key, values in maps.items()]
    words = " ".join(str(dataset.attrs.get(word, "")) for word in _attributes)
    wanted = {quantity: variable for quantity, variable in named.items() if variable is not None}
    chosen, model, dry = _core.recognise(name, words, described, wanted)
    first = maps[chosen[0][1]]
    plane = _plane(first, along, 0)
    times, counted, origin = _times(dataset, along)
    readers: dict[str, Callable[[int], Numbers]] = {}
    changes = {}
    for quantity, variable, factor, offset, _ in chosen:
        values = maps[variable]
        if _plane_dims(values, along) != _plane_dims(first, along):
            raise ValueError(f"{first.name} {first.dims} and {variable} {values.dims} lie on different grids")
        changes[quantity] = along in values.dims
        readers[quantity] = _reader(values, along, factor, offset)
    plane_of_first = first if along not in first.dims else first.isel({along: 0})
    size, place = cells_of_coordinates(plane_of_first)
    turn = sides_of_coordinates(plane_of_first)[2]
    if turn != 0.0 and all(_is_by_compass(maps[name]) for quantity, name, *_ in chosen if quantity in ("u", "v")):
        _turn_to_sides(readers, turn)
    settings = look_settings(look, colour)
    scalars = {}
    for wanted_field in _fields_of(settings):
        if wanted_field in ("water_depth", "velocity_x", "velocity_y", "concentration"):
            continue
        if wanted_field not in maps:
            raise ValueError(f"the dataset has no map {wanted_field!r} to colour by; it has {', '.join(maps)}")
        values = maps[wanted_field]
        if _plane_dims(values, along) != _plane_dims(first, along):
            raise ValueError(f"{first.name} {first.dims} and {wanted_field} {values.dims} lie on different grids")
        scalars[wanted_field] = (" ".join(str(values.attrs.get("long_name", wanted_field)).replace("_", " ").split()),
                                 str(values.attrs.get("units", "")))
        key = f"field {wanted_field}"  # a variable may be called as a quantity is: bed, depth
        changes[key] = along in values.dims
        readers[key] = _reader(values, along, 1.0, 0.0)
    source = _core.RecordSource(name, model, dry, plane.shape, size, place, times, counted, origin, readers, changes, scalars)
    return results_of(source, settings)


def _fields_of(settings: list[str]) -> list[str]:
    """The fields that settings of a look colour by."""
    begin = "look.field="
    return [json.loads(setting.removeprefix(begin)) for setting in settings if setting.startswith(begin)]


def _described(name: str, values: Any, along: str) -> tuple[str, str, str, str, str, bool]:
    standard_name, unit, positive = (str(values.attrs.get(word, "")) for word in ("standard_name", "units", "positive"))
    return name, ", ".join(map(str, values.dims)), standard_name, unit, positive, along in values.dims


def _is_time(key: Any, coordinate: Any) -> bool:
    return (coordinate.dtype.kind == "M" or str(key) == "time" or
            " since " in str(coordinate.attrs.get("units", "")))


def _coordinate_of_records(dataset: Any, along: str) -> Any:
    """The times: the coordinate of the dimension's name, else one over it that is a time. None where there is neither."""
    if along in dataset.coords:
        return dataset.coords[along]
    return next((coordinate for key, coordinate in dataset.coords.items()
                 if coordinate.dims == (along,) and _is_time(key, coordinate)), None)


def _dimension_of_records(dataset: Any) -> str:
    """The dimension of times; else the first of a variable of three. "" where there are no records."""
    for key, coordinate in dataset.coords.items():
        if coordinate.ndim == 1 and _is_time(key, coordinate):
            return str(coordinate.dims[0])
    for values in dataset.data_vars.values():
        over = [str(dim) for dim in values.dims if values.sizes[dim] > 1]
        if len(over) == 3:
            return next(dim for dim in over if dim not in ordered_dims(values))
    return ""


def _plane_dims(values: Any, along: str) -> tuple[str, ...]:
    return tuple(str(dim) for dim in values.dims if dim != along and values.sizes[dim] > 1)


def _is_map(values: Any, along: str) -> bool:
    return values.dtype.kind in "iuf" and len(_plane_dims(values, along)) == 2


def _plane(values: Any, along: str, record: int) -> Numbers:
    """The values of a record, row 0 southernmost, NaN where there are none."""
    plane = values.isel({along: record}) if along in values.dims else values
    plane = plane.squeeze([dim for dim in plane.dims if plane.sizes[dim] == 1 and plane.ndim > 2])
    north, east = ordered_dims(plane)
    plane = plane.transpose(north, east)
    masked = plane.to_masked_array()
    numbers: Numbers = np.where(np.broadcast_to(masked.mask, masked.shape), np.nan, np.asarray(masked.data, dtype=np.float64))
    columns_fall, rows_fall, _ = sides_of_coordinates(plane)
    for axis, falls in enumerate((rows_fall, columns_fall)):
        if falls:
            numbers = np.flip(numbers, axis)
    return np.ascontiguousarray(numbers)


def _reader(values: Any, along: str, factor: float, offset: float) -> Callable[[int], Numbers]:
    if along in values.dims:
        return lambda record: _plane(values, along, record) * factor + offset
    kept: list[Numbers] = []

    def constant(record: int) -> Numbers:
        if not kept:
            kept.append(_plane(values, along, 0) * factor + offset)
        return kept[0]
    return constant


def _is_by_compass(values: Any) -> bool:
    name = str(values.attrs.get("standard_name", ""))
    return "eastward" in name or "northward" in name


def _turn_to_sides(readers: dict[str, Callable[[int], Numbers]], turn: float) -> None:
    """Velocities toward the east and north as those along the columns and rows of a turned grid."""
    if "u" not in readers or "v" not in readers:
        return
    east, north = readers["u"], readers["v"]
    cosine, sine = math.cos(turn), math.sin(turn)
    readers["u"] = lambda record: cosine * east(record) + sine * north(record)
    readers["v"] = lambda record: cosine * north(record) - sine * east(record)


def _times(dataset: Any, along: str) -> tuple[list[float], bool, int | None]:
    """Seconds, whether these are numbers without a unit, and the moment of 0, seconds from 1970."""
    if not along:
        return [0.0], True, None
    times = _coordinate_of_records(dataset, along)
    if times is None:
        return list(map(float, range(dataset.sizes[along]))), True, None
    if times.dtype.kind == "M":
        seconds = times.values.astype("datetime64[ns]").astype(np.int64) / 1e9
        origin = int(np.floor(seconds[0]))
        return [float(one - origin) for one in seconds], False, origin
    if times.dtype.kind == "m":
        return [float(one) / 1e9 for one in times.values.astype("timedelta64[ns]").astype(np.int64)], False, None
    if times.dtype.kind not in "iuf":
        return list(map(float, range(times.size))), True, None
    seconds_per_unit = _core.seconds_per_unit(str(times.attrs.get("units", "")))
    numbers = times.values.astype(float)
    if seconds_per_unit is None:
        return list(map(float, numbers)), True, None
    return [float(one) * seconds_per_unit for one in numbers], False, None


class GrowingFilm:
    """A movie that grows with a running model, a frame for each ``add()``; see fumon.film()."""

    def __init__(self, file: PathLike, rate: float, quality: int, time_unit: str, look: Mapping[str, Setting]) -> None:
        self._file, self._rate, self._look, self._unit = file, rate, look, time_unit
        self._writer = _core.MovieWriter(str(file), float(rate), int(quality))
        self._painter: _core.RecordPainter | None = None
        self._keys: set[str] = set()
        self._count = 0
        self._size = (0, 0)

    def add(self, bed: Heights, depth: Heights | None = None, u: Heights | None = None, v: Heights | None = None, *,
            time: float | None = None, cell_size: CellSize = None, origin: Origin = "lower",
            fields: Mapping[str, str] | None = None) -> Image:
        """Draws the present state, adds it to the movie and returns the picture.

        bed: heights, metres, as fumon.render() takes them, or a grid of Landlab, whose water is taken with it: the fields
            "topographic__elevation" and "surface_water__depth", unless ``fields`` names others
            (``{"bed": "bedrock__elevation", "depth": "h"}``). Grids that are no rasters (HexModelGrid, VoronoiDelaunayGrid …) are
            laid on cells of ``cell_size``, or of half their median edge, linearly in their triangles.
        depth, u, v: water's depth, metres, and its velocity east and north, m/s, of the same shape.
        time: in ``time_unit`` of the film; None: frames are counted.
        """
        names = {"bed": "topographic__elevation", "depth": "surface_water__depth", **(fields or {})}
        is_grid = is_landlab(bed)
        ground = bed_of(bed, cell_size, origin, names["bed"] if is_grid else None)
        planes: dict[str, Numbers] = {"bed": _with_nan(ground)}
        for key, values in (("depth", depth), ("u", u), ("v", v)):
            if values is not None:
                planes[key] = _with_nan(bed_of(values, None, origin))
        if is_grid and depth is None and self._has_depth(bed, fields):  # of the grid's own rows, whatever origin says
            planes["depth"] = _with_nan(bed_of(bed, cell_size, "lower", names["depth"]))
        if self._painter is not None:
            more = sorted(planes.keys() - self._keys)
            if more:
                raise ValueError(f"the first state had no {more[0]}; give it from the first on, zeros where there is none")
            planes.update({key: np.zeros_like(planes["bed"]) for key in self._keys - planes.keys()})
        else:
            self._keys = set(planes)
            self._painter = _core.RecordPainter([f"{key}={value}" for key, value in settings_of(self._look)],
                                                ground.cell_size, self._unit, planes)
        image = Image.drawn(self._painter.draw(planes, self._count, float(self._count if time is None else time)))
        self._size = (image.shape[1], image.shape[0])
        self._writer.add(image)
        self._count += 1
        return image

    @staticmethod
    def _has_depth(grid: Any, fields: Mapping[str, str] | None) -> bool:
        named = (fields or {}).get("depth")
        if named is not None and named not in grid.at_node:
            raise ValueError(f"the grid has no field {named!r} at its nodes to be its depth")
        return (named or "surface_water__depth") in grid.at_node

    def finish(self) -> Movie:
        """Completes the file. ``with fumon.film(...) as film`` does so at its end."""
        if self._count == 0:
            raise ValueError("a film needs a frame: add() the model's state")
        self._writer.finish()
        return Movie(self._file, *self._size, self._count, self._rate)

    def __enter__(self) -> GrowingFilm:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None) -> None:
        if kind is None:
            self.finish()


def film(file: PathLike, *, rate: float = 30.0, quality: int = 18, time_unit: str = "", **look: Setting) -> GrowingFilm:
    """A movie of a running model, a frame for each state that is added::

        with fumon.film("flood.mp4", time_unit="s") as film:
            while flow.elapsed < 3600:
                flow.run_one_step()
                film.add(grid, time=flow.elapsed)

    The first state frames the picture. time_unit: of the times that are given, for the plate ("s", "h", "yr"); empty: frames are
    counted. rate, quality: as for fumon.movie(); look: keys of a scene, as for fumon.render().
    """
    return GrowingFilm(file, rate, quality, time_unit, look)


def _with_nan(bed: Any) -> Numbers:
    heights: Numbers = bed.heights
    if bed.nodata is not None:
        heights = heights.copy()
        heights[bed.nodata != 0] = np.nan
    return heights
