"""Stored records of runs, of fumon's and of other models: opened, drawn, filmed."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Iterator, overload

import numpy as np

from . import _core
from .arrays import Numbers
from .axes import Axes, FigureAxes, figure_axes
from .images import Image, PathLike
from .measures import Measures
from .movies import Movie, movie
from .scene import Step
from .settings import Setting, look_settings, settings_of


class Record(Step):
    """A record of a run. It has what a Step of a run has; a notebook shows its picture."""

    def __init__(self, results: _core.Results, number: int, date: str | None) -> None:
        super().__init__(results.record(number))
        self._results, self._number, self._date = results, number, date

    @property
    def date(self) -> str | None:
        """"2019-08-31 14:00 UTC", where the run's times have dates."""
        return self._date

    @property
    def measures(self) -> Measures:
        """What ``fumon measure`` tells of this record. Celerities are NaN, which need a record before."""
        return Measures(self._results.measured(self._number).measured)


class Results(Sequence[Record]):
    """The stored records of a run, read one at a time as they are asked for: ``results[0]``, ``results[-1].image()``,
    ``for record in results``. ``print(results.description)`` says what was recognised."""

    def __init__(self, core: _core.Results) -> None:
        self._core = core
        self._dates = core.dates
        self._count = len(core.times)

    @overload
    def __getitem__(self, number: int) -> Record: ...
    @overload
    def __getitem__(self, number: slice) -> list[Record]: ...

    def __getitem__(self, number: int | slice) -> Record | list[Record]:
        if isinstance(number, slice):
            return [self[one] for one in range(*number.indices(len(self)))]
        index = number + len(self) if number < 0 else number
        if not 0 <= index < len(self):
            raise IndexError(f"record {number} of {len(self)}")
        return Record(self._core, index, self._dates[index] if self._dates else None)

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Record]:
        return (self[number] for number in range(len(self)))

    @property
    def name(self) -> str:
        """The file or folder, as it was given."""
        return self._core.name

    @property
    def times(self) -> Numbers:
        """Of all records, in ``time_unit``; from the first on where there are dates."""
        return np.array(self._core.times, dtype=np.float64)

    @property
    def time_unit(self) -> str:
        """"s", "min", "h", "d", "yr" or "steps"."""
        return self._core.time_unit

    @property
    def dates(self) -> list[str]:
        """Of all records; empty where their times have none."""
        return list(self._dates)

    @property
    def steps(self) -> list[int]:
        """The number of each record, as ``fumon still --step`` takes it."""
        return self._core.steps

    @property
    def fields(self) -> dict[str, tuple[str, str, str]]:
        """Of another model's run: what is drawn ("bed", "depth", "level", "u" …) and, for each, its variable, the unit there,
        and how it was known."""
        return {key: (name, unit, reason) for key, name, unit, reason in self._core.fields}

    @property
    def description(self) -> str:
        """What ``fumon describe FILE`` says of another model's run, with the ranges of its fields; else empty."""
        return self._core.description

    def still(self, file: PathLike, record: int = -1) -> None:
        """Writes the picture of a record, by the file's ending PNG, JPEG, WebP or OpenEXR."""
        self[record].save(file)

    def image(self, record: int = -1) -> Image:
        """The picture of a record."""
        return self[record].image()

    def figure(self, ax: Axes, record: int = -1) -> FigureAxes:
        """Puts the picture of a record into axes of Matplotlib, see fumon.figure_axes()."""
        return figure_axes(ax, self[record])

    def movie(self, file: PathLike, *, every: int = 1, rate: float = 30.0, quality: int = 18,
              progress: bool | None = None) -> Movie:
        """A movie with a frame for each record, or each ``every``-th one; ``rate``, ``quality``: as for fumon.movie()."""
        if every < 1:
            raise ValueError(f"every is a number of records, at least 1, not {every}")
        frames = (self[number].image() for number in range(0, len(self), every))
        return movie(frames, file, rate=rate, quality=quality, progress=progress)

    def film(self, file: PathLike, film: PathLike | None = None, *, style: str = "talk", seconds: float = 0.0,
             **settings: Setting) -> Movie:
        """A film as ``fumon film`` makes it: with moving camera, by rule or by the film file ``film`` (or the name of a film that
        ships). ``style`` and ``seconds`` are those of a film by rule. settings: keys of the film, as ``film_width=640``.

        InputError where film and run do not fit; KeyboardInterrupt leaves no file.
        """
        told = self._core.film(os.fspath(file), "" if film is None else os.fspath(film), style, float(seconds),
                               [f"{key}={value}" for key, value in settings_of(settings)])
        return Movie(file, told["width"], told["height"], told["frames"], told["frames"] / max(told["seconds"], 1e-9))

    def __repr__(self) -> str:
        return f"<fumon.Results {self.name}: {len(self)} records>"


def open(path: PathLike, *, fields: Mapping[str, str] | None = None, cell_size: float = 0.0, time_pattern: str = "",
         time_unit: str = "", colour: str | None = None, **look: Setting) -> Results:
    """Opens stored records: the folder of a run, its fields.nc alone, or results of other models, which are a NetCDF file
    (on rectangles, triangles or polygons), a pattern of several (``"out_*.nc"``) or of rasters (``"elev_*.asc"``).

    fields: which variable or file is what, where that is not recognised: ``{"depth": "h", "bed": "dem.tif"}``; of bed, depth,
        level, u, v, qx, qy, concentration.
    cell_size: metres, of rasters that do not say theirs, and of the grid on which triangles and polygons are laid.
    time_pattern: of dates in the names of a series of rasters, ``"%Y-%m-%d"``; time_unit: of numbers there, and of times without
        a unit.
    colour: what colours the ground: a field of the run or a variable of the file, or a word of look.colour_by ("height", "slope").
        Pictures name it, with its unit, beside its colours; the record has it among its ``fields``.
    look: keys of the scene by which records are drawn, as ``camera_azimuth=160``.

    InputError, one line, for what is not read, is damaged or is not recognised.
    """
    named = [f"{key}={name}" for key, name in (fields or {}).items()]
    settings = look_settings(look, colour)
    return Results(_core.Results(os.fspath(path), named, time_pattern, time_unit, float(cell_size), settings))


def results_of(source: _core.RecordSource, settings: list[str]) -> Results:
    """Of records that Python reads, drawn by settings "key=VALUE"."""
    return Results(_core.Results.of_records(source, settings))
