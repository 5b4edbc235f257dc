"""Anyone's terrain: arrays, xarray's, Landlab's grids; drawn and measured."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, Mapping, Tuple, Union

import numpy as np

from . import _core
from .arrays import Bytes, Heights, Numbers
from .images import Image
from .layers import Layers
from .measures import Measures
from .settings import Setting, settings_of

CellSize = Union[float, "tuple[float, float]", None]
Origin = Literal["lower", "upper"]

_names_of_y = {"y", "lat", "latitude", "northing", "north", "projection_y_coordinate"}
_names_of_x = {"x", "lon", "longitude", "easting", "east", "projection_x_coordinate"}
_evenness = 0.05  # of a cell, by which coordinates may stand off the even line, as of files

#: West and south of the grid's edges, dx and dy in the coordinates' own unit, whether that is degrees, and their system.
Place = Tuple[float, float, float, float, bool, str]


@dataclass
class Bed:
    """Heights as the core takes them: float64 (ny, nx), row 0 southernmost, and what lies outside."""

    heights: Numbers
    nodata: Bytes | None
    cell_size: tuple[float, float] | None
    place: Place | None = None


def render(data: Heights, cell_size: CellSize = None, *, origin: Origin = "lower", field: str | None = None,
           drape: Bytes | None = None, **look: Setting) -> Image:
    """A picture of a terrain.

    data: heights, metres, of any real dtype and strides: an array (ny, nx), whose NaN and masked cells have no data;
        an xarray.DataArray; or a raster grid of Landlab, of which ``field`` names the heights.
    cell_size: metres, or (dx, dy). A DataArray with coordinates and Landlab's grids bring it; without one, heights
        count in cells.
    origin: "lower" where row 0 of an array is the southernmost (as fumon and Landlab have it), "upper" where it is
        the northernmost (as most rasters have it). The coordinates of a DataArray say so themselves.
    drape: a picture laid over the terrain and fitted to its extent: uint8 (height, width, 3), or 4 with opacity,
        the northernmost row first. ``look_drape="photo.tif"`` names a file; ``look_drape_strength`` and
        ``look_drape_light`` hold for both.
    look: keys of a scene, with an underscore for the dot: ``camera_azimuth=160, look_palette="viridis",
        image_width=800``. ``layers`` lays lines, points and areas over the terrain: a vector file, GeoJSON, a
        GeoDataFrame, a mapping of the keys of ``[[layer]]``, or a list of these. They are brought to the reference
        system of a DataArray; over an array they are metres from its south-western corner.

    Returns uint8 (height, width, 3), top row first. With ``look_background="transparent"`` it is the block alone, as
    (height, width, 4) with alpha, by which colours are not multiplied.

    ValueError and TypeError for what is no terrain; InputError for a wrong key.
    """
    bed = bed_of(data, cell_size, origin, field)
    return Image.drawn(_painter(bed, look, drape).first())


def render_layers(data: Heights, cell_size: CellSize = None, *, origin: Origin = "lower", field: str | None = None,
                  drape: Bytes | None = None, **look: Setting) -> Layers:
    """The light of the picture that render() gives, before exposure and tone curve, and what each of its pixels shows:
    depth, normals, positions, heights. Arguments and errors as for render()."""
    bed = bed_of(data, cell_size, origin, field)
    return Layers.drawn(_painter(bed, look, drape).layers())


def measure(data: Heights, cell_size: CellSize = None, *, origin: Origin = "lower", field: str | None = None,
            periodic: bool = True, channel_area: float = 0.0) -> Measures:
    """The measures of a terrain, as ``fumon measure`` has them: wavelengths, crests, slopes, dunes. In metres where
    there is a cell size, else in cells. data, cell_size, origin, field: as for render(). periodic: the bed goes on
    past its edges with its other side, as for the command; False, its ``--open``, for terrain that ends there.
    channel_area: above 0, the network of channels through which at least this area drains (m², or cells) is measured
    too."""
    if not 0.0 <= channel_area < float("inf"):
        raise ValueError(f"channel_area is {channel_area}; it takes 0 or an area above it")
    bed = bed_of(data, cell_size, origin, field)
    return Measures(_core.measure_bed(bed.heights, bed.nodata, bed.cell_size, periodic, channel_area))


def _painter(bed: Bed, look: Mapping[str, Setting], drape: Bytes | None = None) -> _core.BedPainter:
    if drape is not None:
        drape = np.asarray(drape)
        if drape.dtype != np.uint8:
            raise TypeError(f"drape is an array of uint8, not {drape.dtype}")
    scene = _core.SceneValue.terrain(settings_of(look))
    return _core.BedPainter(scene, bed.heights, bed.nodata, bed.cell_size, bed.place, drape)


class Painter:
    """Draws beds of one shape, framed by the first of them."""

    def __init__(self, look: Mapping[str, Setting]) -> None:
        self._look = look
        self._painter: _core.BedPainter | None = None

    def draw(self, bed: Bed) -> Image:
        """A picture of it."""
        if self._painter is None:
            self._painter = _painter(bed, self._look)
        return Image.drawn(self._painter.draw(bed.heights, bed.nodata))


def bed_of(data: Heights, cell_size: CellSize = None, origin: Origin = "lower", field: str | None = None) -> Bed:
    """Whatever holds heights, as a Bed."""
    if origin not in ("lower", "upper"):
        raise ValueError(f'origin is "lower" or "upper", not {origin!r}')
    size = _checked_size(cell_size)
    if is_landlab(data):
        return _bed_of_landlab(data, size, field or "topographic__elevation")
    if field is not None:
        raise ValueError("field names the heights of a Landlab grid, which this is not")
    if hasattr(data, "data_vars"):
        raise TypeError("a Dataset holds several variables; choose the heights, as dataset[\"bed\"]")
    if hasattr(data, "dims") and hasattr(data, "coords"):
        return _bed_of_dataarray(data, size, origin)
    return _bed_of_array(data, size, flipped=origin == "upper")


def held_bed(data: Any, cell_size: CellSize = None, origin: Origin = "lower", field: str | None = None) -> _core.HeldBed:
    """Whatever holds heights, as a bed that scenes of this process find by its name."""
    bed = bed_of(data, cell_size, origin, field)
    place = _place_of(data) if hasattr(data, "dims") and hasattr(data, "coords") else None
    size, unit_counts = bed.cell_size, None
    if place is not None and cell_size is None:
        _, _, dx, dy, degrees, _ = place
        has_unit = any(data.coords[dim].attrs.get("units") for dim in ordered_dims(data)) and not degrees
        size, unit_counts = size if has_unit else (dx, dy), not has_unit
    return _core.HeldBed(bed.heights, bed.nodata, size, place, unit_counts)


def _place_of(array: Any) -> Place | None:
    """Where a DataArray lies, by its coordinates; None where they count cells."""
    north, east = ordered_dims(array)
    if not all(dim in array.coords and array.sizes[dim] > 1 for dim in (north, east)):
        return None
    x, y = array.coords[east], array.coords[north]
    dx, dy = _spacing(x), _spacing(y)
    if dx is None or dy is None or "1" in (x.attrs.get("units"), y.attrs.get("units")):
        return None
    west, south = float(np.min(x.values)) - 0.5 * dx, float(np.min(y.values)) - 0.5 * dy
    return west, south, dx, dy, "degrees" in (_unit(x), _unit(y)), _crs_of(array)


def cells_of_coordinates(array: Any) -> tuple[tuple[float, float] | None, Place | None]:
    """The size of an array's cells, metres, and where it lies, by its coordinates: those of its dimensions, or x and y over both."""
    north, east = ordered_dims(array)
    array = array.squeeze([dim for dim in array.dims if dim not in (north, east)])
    if east in array.coords and north in array.coords:
        return _size_of_coordinates(array.coords[east], array.coords[north]), _place_of(array)
    planes = _planes_of_coordinates(array, north, east)
    if planes is None:
        return None, None
    dx, dy = (float(np.hypot(*(np.diff(plane, axis=axis).mean() for plane in planes))) for axis in (1, 0))
    return (dx, dy) if dx > 0 and dy > 0 else None, None


def _planes_of_coordinates(array: Any, north: str, east: str) -> list[Numbers] | None:
    """x and y over both dimensions."""
    planes = [array.coords[name].transpose(north, east).values for name in ("x", "y")
              if name in array.coords and set(array.coords[name].dims) == {north, east}]
    return planes if len(planes) == 2 and min(planes[0].shape) > 1 else None


def sides_of_coordinates(array: Any) -> tuple[bool, bool, float]:
    """Whether the columns and rows of an array (…, y, x) run against its east and north, and by how much its columns are then turned
    against the east, radians: 0 but where x and y are over both dimensions."""
    north, east = ordered_dims(array)
    if east in array.coords and north in array.coords:
        planes = None
    else:
        planes = _planes_of_coordinates(array, north, east)
    if planes is None:
        falls = [dim in array.coords and array.sizes[dim] > 1 and array.coords[dim].values[-1] < array.coords[dim].values[0]
                 for dim in (east, north)]
        return bool(falls[0]), bool(falls[1]), 0.0
    x, y = planes
    along, across = ((float(x[at] - x[0, 0]), float(y[at] - y[0, 0])) for at in ((0, -1), (-1, 0)))
    columns_fall = along[0] < 0
    if columns_fall:
        along = -along[0], -along[1]
    turn = float(np.arctan2(along[1], along[0]))
    return columns_fall, along[0] * across[1] - along[1] * across[0] < 0, turn if abs(turn) > 1e-3 else 0.0


def _crs_of(array: Any) -> str:
    """The reference system that rioxarray or CF's grid mapping notes, as WKT or "EPSG:32613"; empty where there is none."""
    name = array.attrs.get("grid_mapping") or array.encoding.get("grid_mapping") or "spatial_ref"
    noted = array.coords[name].attrs if name in array.coords else {}
    for attributes, key in ((noted, "crs_wkt"), (noted, "spatial_ref"), (array.attrs, "crs_wkt"), (array.attrs, "crs")):
        if attributes.get(key):
            return str(attributes[key])
    return ""


def _checked_size(cell_size: CellSize) -> tuple[float, float] | None:
    if cell_size is None:
        return None
    sizes = np.atleast_1d(np.asarray(cell_size, dtype=float))
    if sizes.shape not in ((1,), (2,)) or not np.all(np.isfinite(sizes)) or not np.all(sizes > 0):
        raise ValueError(f"cell_size is metres, or (dx, dy) in metres, above 0, not {cell_size!r}")
    return float(sizes[0]), float(sizes[-1])


def _bed_of_array(data: Any, size: tuple[float, float] | None, flipped: bool) -> Bed:
    masked = np.broadcast_to(data.mask, data.shape) if isinstance(data, np.ma.MaskedArray) else None
    values = data.data if isinstance(data, np.ma.MaskedArray) else np.asarray(data)
    if values.dtype.kind not in "iuf":
        raise TypeError(f"heights are real numbers, not {values.dtype}")
    if values.ndim != 2:
        hint = "; this looks like a picture" if values.ndim == 3 and values.shape[2] in (3, 4) else ""
        raise ValueError(f"heights are an array (ny, nx), not {values.shape}{hint}")
    if values.size == 0:
        raise ValueError(f"heights are an array with cells, not {values.shape}")
    if flipped:
        values = values[::-1]
    heights = np.array(values, dtype=np.float64, order="C")
    nodata = np.isnan(heights)
    if masked is not None:
        nodata |= masked[::-1] if flipped else masked
    if np.any(np.isinf(heights[~nodata])):
        y, x = np.argwhere(np.isinf(heights) & ~nodata)[0]
        raise ValueError(f"the height at row {y}, column {x} (from the south-west) is infinite; NaN stands for no data")
    if nodata.all():
        raise ValueError("no cell has data")
    heights[nodata] = 0.0
    return Bed(heights, nodata.astype(np.uint8) if nodata.any() else None, size)


def is_landlab(data: Any) -> bool:
    """Whether something has the attributes of a grid of Landlab: a raster, or nodes anywhere."""
    return hasattr(data, "at_node") and (hasattr(data, "shape") or hasattr(data, "x_of_node"))


def _bed_of_nodes(grid: Any, size: tuple[float, float] | None, field: str) -> Bed:
    """Of a HexModelGrid, VoronoiDelaunayGrid …: linear in the triangles of its patches, no data outside them."""
    if not hasattr(grid, "nodes_at_patch"):
        raise TypeError("a grid that is no raster needs nodes_at_patch, the corners of its triangles, as Landlab's grids have it")
    if size is not None and size[0] != size[1]:
        raise ValueError("nodes are laid on square cells: cell_size is one number")
    mesh = _core.NodeMesh(np.asarray(grid.x_of_node, dtype=np.float64), np.asarray(grid.y_of_node, dtype=np.float64),
                          np.asarray(grid.nodes_at_patch, dtype=np.int64), 0.0 if size is None else float(size[0]))
    values = mesh.laid(np.asarray(grid.at_node[field], dtype=np.float64))
    return _bed_of_array(values, (mesh.cell, mesh.cell), flipped=False)


def _bed_of_landlab(grid: Any, size: tuple[float, float] | None, field: str) -> Bed:
    if field not in grid.at_node:
        raise ValueError(f"the grid has no field {field!r} at its nodes; field= names the one with the heights")
    if not hasattr(grid, "dx"):
        return _bed_of_nodes(grid, size, field)
    dx = float(grid.dx)
    own = (dx, float(getattr(grid, "dy", dx)))
    return _bed_of_array(np.asarray(grid.at_node[field]).reshape(grid.shape), size or own, flipped=False)


def _axis_of(array: Any, names: set[str], axis: str) -> str | None:
    for dim in array.dims:
        attributes = array.coords[dim].attrs if dim in array.coords else {}
        if (str(dim).lower() in names or attributes.get("standard_name") in names or attributes.get("axis") == axis):
            return str(dim)
    return None


def ordered_dims(array: Any) -> tuple[str, str]:
    """The dimensions of a DataArray that run north and east: by their names or attributes, else the last two."""
    north, east = _axis_of(array, _names_of_y, "Y"), _axis_of(array, _names_of_x, "X")
    if north is None and east is None:
        return str(array.dims[-2]), str(array.dims[-1])
    if north is None or east is None:
        known = north or east
        others = [str(dim) for dim in array.dims if str(dim) != known and array.sizes[dim] > 1]
        if len(others) != 1:
            raise ValueError(f"which of the dimensions {tuple(array.dims)} run north and east? Call them y and x")
        north, east = north or others[0], east or others[0]
    return north, east


def _bed_of_dataarray(array: Any, size: tuple[float, float] | None, origin: Origin) -> Bed:
    if array.ndim < 2:
        raise ValueError(f"heights have two dimensions, not {tuple(array.dims)}")
    north, east = ordered_dims(array)
    extra = [dim for dim in array.dims if dim not in (north, east)]
    if any(array.sizes[dim] != 1 for dim in extra):
        raise ValueError(f"heights have two dimensions, not {tuple(array.dims)}; choose one of {extra[0]} by "
                         f".isel({extra[0]}=0)")
    array = array.squeeze(extra).transpose(north, east)
    x, y = (array.coords[dim] if dim in array.coords else None for dim in (east, north))
    values = array.to_masked_array() if array.dtype.kind in "iuf" else array.values
    if x is not None and array.sizes[east] > 1 and x.values[-1] < x.values[0]:
        values = values[:, ::-1]
    is_upper = origin == "upper"
    if y is not None and array.sizes[north] > 1:
        is_upper = bool(y.values[-1] < y.values[0])
    counts = size is None and x is not None and y is not None
    if counts:
        size = _size_of_coordinates(x, y)
    factor = _height_factor(array)
    bed = _bed_of_array(values if factor == 1.0 else values * factor, size, is_upper)
    if counts:
        bed.place = _place_of(array)
    return bed


def _height_factor(array: Any) -> float:
    """What heights are multiplied by: metres of their unit, negative where they are depths, as of NetCDF files."""
    unit = str(array.attrs.get("units", ""))
    metres = _core.metres_per_height(unit)
    if metres is None:
        raise ValueError(f"{array.name or 'the heights'}: in {unit!r}; heights are in a unit of length (\"m\")")
    positive, standard = (str(array.attrs.get(name, "")) for name in ("positive", "standard_name"))
    return -metres if _core.grows_downward(positive, standard) else metres


def _spacing(coordinate: Any) -> float | None:
    values = np.asarray(coordinate.values)
    if values.size < 2 or values.dtype.kind not in "iuf":
        return None
    values = values.astype(float)
    even = np.linspace(values[0], values[-1], values.size)
    spacing = abs(values[-1] - values[0]) / (values.size - 1)
    if spacing == 0.0 or not np.all(np.abs(values - even) <= _evenness * spacing):
        raise ValueError(f"{coordinate.name} is not evenly spaced; bring the heights onto an even grid")
    return float(spacing)


def _size_of_coordinates(x: Any, y: Any) -> tuple[float, float] | None:
    dx, dy = _spacing(x), _spacing(y)
    if (dx is None and dy is None) or x.attrs.get("units") == "1":  # sites
        return None
    east, north = _unit(x), _unit(y)
    if east == "degrees" or north == "degrees":
        east, north = _core.metres_per_degree(float(np.mean(y.values)))
    dx = None if dx is None else dx * float(east)
    dy = None if dy is None else dy * float(north)
    return dx or dy or 1.0, dy or dx or 1.0


def _unit(coordinate: Any) -> float | str:
    """Metres of the coordinate's unit, or "degrees"."""
    unit = str(coordinate.attrs.get("units", ""))
    name = str(coordinate.name).lower()
    if _core.is_degrees(unit) or (not unit and name in {"lat", "latitude", "lon", "longitude"}):
        return "degrees"
    metres = _core.metres_per_unit(unit) if unit else 1.0
    if metres is None:
        raise ValueError(f"{coordinate.name} is in {unit!r}; give cell_size in metres")
    return metres
