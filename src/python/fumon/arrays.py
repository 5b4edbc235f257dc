"""Arrays by what they hold, and what others' grids have, for type checkers."""

from __future__ import annotations

from typing import Any, Mapping, Protocol, Union

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.generic]
Numbers = npt.NDArray[np.float64]
Floats = npt.NDArray[np.float32]
Bytes = npt.NDArray[np.uint8]


class RasterGrid(Protocol):
    """What of a raster grid of Landlab is used."""

    @property
    def at_node(self) -> Mapping[str, Any]:
        """Its fields."""

    @property
    def shape(self) -> tuple[int, ...]:
        """(rows, columns)."""

    @property
    def dx(self) -> float:
        """Of its cells, metres."""


class Dataset(Protocol):
    """What of an xarray.Dataset tells it from an array."""

    @property
    def data_vars(self) -> Mapping[Any, Any]:
        """Its variables."""


Heights = Union[npt.ArrayLike, RasterGrid]  #: an array, an xarray.DataArray, or a grid of Landlab
