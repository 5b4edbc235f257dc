"""Numbers for every cell of a terrain: slope, aspect, shaded relief, drained area, wetness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _core
from .arrays import Numbers
from .terrain import CellSize, Origin, bed_of, ordered_dims


@dataclass
class Raster:
    """Values (ny, nx), NaN where there are none, with their unit and what they are."""

    values: Numbers
    unit: str
    long_name: str


def raster(data: Any, quantity: str, cell_size: CellSize = None, *, origin: Origin = "lower", field: str | None = None,
           sun_azimuth: float = 315.0, sun_elevation: float = 45.0, exaggeration: float = 1.0) -> Numbers:
    """One number for each cell of a terrain, as ``fumon export --field`` writes it: float64 (ny, nx), NaN where there
    is none, rows and columns in the order of those of ``data``.

    data, cell_size, origin, field: as for render().
    quantity: "height"; "slope", degrees from the horizontal, and "aspect", degrees clockwise from north, NaN where it
        is level (Horn 1981); "hillshade", 1 to 255, under a sun from ``sun_azimuth``, ``sun_elevation`` over heights
        times ``exaggeration``; "drainage", the area that drains through the cell, m2, or cells without a cell size;
        "wetness", ln(a / tan b) (Beven & Kirkby 1979).

    InputError for another quantity; ValueError and TypeError for what is no terrain."""
    return made_raster(data, quantity, cell_size, origin, field, (sun_azimuth, sun_elevation, exaggeration)).values


def made_raster(data: Any, quantity: str, cell_size: CellSize, origin: Origin, field: str | None,
                light: tuple[float, float, float]) -> Raster:
    """The same with its unit and description."""
    if not np.all(np.isfinite(light)):
        raise ValueError(f"sun_azimuth, sun_elevation and exaggeration are numbers, not {light}")
    bed = bed_of(data, cell_size, origin, field)
    values, unit, long_name = _core.raster_of_bed(bed.heights, bed.nodata, bed.cell_size, quantity, *light)
    falls_north, falls_east = _falls(data, origin)
    ordered = values[::-1 if falls_north else 1, ::-1 if falls_east else 1]
    return Raster(np.array(ordered, order="C"), unit, long_name)


def _falls(data: Any, origin: Origin) -> tuple[bool, bool]:
    """Whether the rows of data run south and its columns west."""
    if hasattr(data, "at_node"):
        return False, False
    if not (hasattr(data, "dims") and hasattr(data, "coords")):
        return origin == "upper", False

    def falls(dim: str, otherwise: bool) -> bool:
        if dim not in data.coords or data.sizes[dim] < 2:
            return otherwise
        return bool(data.coords[dim].values[-1] < data.coords[dim].values[0])

    north, east = ordered_dims(data)
    return falls(north, origin == "upper"), falls(east, False)
