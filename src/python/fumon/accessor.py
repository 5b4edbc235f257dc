"""``.fumon`` on xarray's DataArray and Dataset."""

from __future__ import annotations

from typing import Any, Mapping

import xarray

from .arrays import Bytes
from .axes import Axes, FigureAxes
from .datasets import results_of_dataset
from .images import Image, PathLike
from .measures import Measures
from .movies import Movie, movie
from .rasters import made_raster
from .results import Results
from .settings import Setting
from .terrain import CellSize, Origin, measure, ordered_dims, render

# Versions of xarray differ in whether these have types.
_register_dataarray_accessor: Any = xarray.register_dataarray_accessor
_register_dataset_accessor: Any = xarray.register_dataset_accessor


@_register_dataarray_accessor("fumon")
class TerrainAccessor:
    """Heights: ``array.fumon.render(camera_azimuth=160)``. The cell size is that of its coordinates."""

    def __init__(self, array: xarray.DataArray) -> None:
        self._array = array

    def render(self, cell_size: CellSize = None, *, origin: Origin = "lower", drape: Bytes | None = None,
               **look: Setting) -> Image:
        """A picture, see fumon.render()."""
        return render(self._array, cell_size, origin=origin, field=None, drape=drape, **look)

    def measure(self, cell_size: CellSize = None, *, origin: Origin = "lower", periodic: bool = True,
                channel_area: float = 0.0) -> Measures:
        """Its measures, see fumon.measure()."""
        return measure(self._array, cell_size, origin=origin, periodic=periodic, channel_area=channel_area)

    def raster(self, quantity: str, cell_size: CellSize = None, *, origin: Origin = "lower", sun_azimuth: float = 315.0,
               sun_elevation: float = 45.0, exaggeration: float = 1.0) -> xarray.DataArray:
        """A number for each cell on the same coordinates, see fumon.raster()."""
        made = made_raster(self._array, quantity, cell_size, origin, None, (sun_azimuth, sun_elevation, exaggeration))
        dims = ordered_dims(self._array)
        coordinates = {dim: self._array.coords[dim] for dim in dims if dim in self._array.coords}
        return xarray.DataArray(made.values, coords=coordinates, dims=dims, name=quantity,
                                attrs={"units": made.unit, "long_name": made.long_name})

    def movie(self, file: PathLike, **options: Any) -> Movie:
        """A movie over its third dimension, see fumon.movie()."""
        return movie(self._array, file, **options)


@_register_dataset_accessor("fumon")
class DatasetAccessor:
    """``dataset.fumon.movie("growth.mp4")``."""

    def __init__(self, dataset: xarray.Dataset) -> None:
        self._dataset = dataset

    def results(self, *, bed: str | None = None, depth: str | None = None, level: str | None = None, u: str | None = None,
                v: str | None = None, colour: str | None = None, **look: Setting) -> Results:
        """Its records as a run, which fumon.open() gives of a file: what is bed and water is recognised by CF standard names and the
        names of models, or named here. Values are read, or computed by Dask, a record at a time. colour: a variable that colours the
        ground, see fumon.open(); look: keys of a scene."""
        named = {"bed": bed, "depth": depth, "level": level, "u": u, "v": v}
        return results_of_dataset(self._dataset, named, look, colour=colour)

    def still(self, file: PathLike, record: int = -1, **options: Any) -> None:
        """Writes the picture of a record. options: variables and look, as for results()."""
        self.results(**options).still(file, record)

    def figure(self, ax: Axes, record: int = -1, **options: Any) -> FigureAxes:
        """Puts the picture of a record into axes of Matplotlib, with ticks in its unit, see fumon.figure_axes(). options: variables
        and look, as for results()."""
        return self.results(**options).figure(ax, record)

    def film(self, file: PathLike, film: PathLike | None = None, *, style: str = "talk", seconds: float = 0.0,
             film_settings: Mapping[str, Setting] | None = None, **options: Any) -> Movie:
        """A film with a moving camera, see Results.film(), whose keys film_settings sets. options: variables and look, as for
        results()."""
        return self.results(**options).film(file, film, style=style, seconds=seconds, **(film_settings or {}))

    def movie(self, file: PathLike, *, bed: str | None = None, depth: str | None = None, level: str | None = None,
              u: str | None = None, v: str | None = None, rate: float = 30.0, quality: int = 18,
              colour: str | None = None, progress: bool | None = None, **options: Any) -> Movie:
        """A movie with a frame for each record. Where water is recognised or named (depth, level), or a colour is, it is drawn, and options are keys
        of a scene; else, and with cell_size, origin or variable, it is a movie of heights, see fumon.movie()."""
        named = {"bed": bed, "depth": depth, "level": level, "u": u, "v": v}
        of_heights = sorted(options.keys() & {"cell_size", "origin", "variable"})
        if of_heights and any(named.values()):
            also = next(quantity for quantity, name in named.items() if name)
            raise TypeError(f"{of_heights[0]} is of a movie of heights alone, which takes no {also}")
        if any(named.values()) or colour or (not of_heights and self._has_water()):
            return results_of_dataset(self._dataset, named, options, colour=colour).movie(file, rate=rate, quality=quality, progress=progress)
        return movie(self._dataset, file, rate=rate, quality=quality, progress=progress, **options)

    def _has_water(self) -> bool:
        try:
            fields = results_of_dataset(self._dataset, {}, {}).fields
        except ValueError:  # InputError among them
            return False
        return "depth" in fields or "level" in fields
