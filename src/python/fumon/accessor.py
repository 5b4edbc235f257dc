"""``.fumon`` on xarray's DataArray and Dataset."""

from __future__ import annotations

from typing import Any

import xarray

from .arrays import Bytes
from .images import Image, PathLike
from .measures import Measures
from .movies import Movie, movie
from .rasters import made_raster
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

    def movie(self, file: PathLike, **options: Any) -> Movie:
        """A movie of its heights, see fumon.movie()."""
        return movie(self._dataset, file, **options)
