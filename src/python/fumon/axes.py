"""Views, maps and palettes for Matplotlib, which is imported when one of these functions is called."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Heights, Numbers
from .scene import Run, Scene, Step
from .settings import Setting, key_of
from .terrain import CellSize, Origin

# Matplotlib's classes, of which only its newer versions have types.
Axes = Any
AxesImage = Any

Drawn = Union[Scene, Run, Step, Heights]  #: what figure_axes() shows

@dataclass(frozen=True)
class FigureAxes:
    """What figure_axes() has put into axes of Matplotlib."""

    ax: Axes
    image: AxesImage
    extent: tuple[float, float, float, float]  #: west, east, south, north of the bed, in ``unit``
    unit: str  #: "m", "degrees", "sites" without metres, or "" for the unit of a reference system
    crs: str  #: that system as well-known text; empty where none is known
    exaggeration: float  #: of heights, in a view
    _shown: _core._Projection
    _heights: Numbers  #: of the bed, metres or model heights

    def project(self, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike | None = None) -> tuple[Numbers, Numbers]:
        """Where places of the ground are seen, in the data coordinates of the axes: for ``ax.annotate``, ``ax.plot``.

        x, y: in the coordinates of ``extent``. z: height, metres (model heights in a model of sites); None: that of
        the cell. Of any shapes that broadcast. What lies behind the camera is NaN. A map shows places where they are.
        """
        east, north = np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)
        if self._shown["is_map"]:
            return np.array(east), np.array(north)
        left, right, low, high = self.extent
        across, along = (east - left) / (right - left), (north - low) / (high - low)
        height = self._ground(across, along) if z is None else np.asarray(z, dtype=np.float64)
        shown = self._shown
        points = np.stack(np.broadcast_arrays(
            across * shown["extent"][0] / shown["side"] - 0.5 * shown["width"][0],
            along * shown["extent"][1] / shown["side"] - 0.5 * shown["width"][1],
            (height / shown["height_unit"] - shown["reference"]) * shown["height_scale"]), axis=-1)
        right_up_forward = (points - np.array(shown["eye"])) @ np.array(shown["axes"]).T
        half = np.array(shown["half"])
        depth = right_up_forward[..., 2:]
        with np.errstate(divide="ignore", invalid="ignore"):
            seen = right_up_forward[..., :2] / (half * np.where(depth > 0, depth, np.nan) if shown["perspective"] else half)
        width, tall = shown["pixels"]
        return 0.5 * (1 + seen[..., 0]) * width, 0.5 * (1 - seen[..., 1]) * tall

    def _ground(self, across: npt.NDArray[np.floating[Any]], along: npt.NDArray[np.floating[Any]]) -> Numbers:
        ny, nx = self._heights.shape
        column = np.clip((across * nx).astype(int), 0, nx - 1)
        row = np.clip((along * ny).astype(int), 0, ny - 1)
        ground: Numbers = self._heights[row, column]
        return ground


def figure_axes(ax: Axes, what: Drawn, cell_size: CellSize = None, *, origin: Origin = "lower", field: str | None = None,
                step: int | None = None, dots_per_inch: float = 300.0, **look: Setting) -> FigureAxes:
    """Puts a view or, with ``camera_projection="map"``, a map into axes of Matplotlib.

    what: a Scene, which is run to ``step`` (its last one), a Run, of which the next step is taken, a Step, or heights, with
        ``cell_size``, ``origin`` and ``field`` as render() takes them.
    dots_per_inch: how fine the picture is, where ``image_width`` and ``image_height`` do not say it.
    look: keys of a scene, ``camera_azimuth=160, look_colour_by="height"``; for a Step and a Run, the scene's own hold.

    A map's axes count the metres from the bed's south-western corner or, where the bed lies on a map, the coordinates of
    its reference system; the bed fills them, at equal scales. A view's axes count pixels from the upper left corner, have
    no frame, and the ground lies on the axes' own colour; ``project()`` of the result says where a place of the ground is.

    Returns a FigureAxes. Raises ImportError without Matplotlib, errors as render() and Scene.run() do.
    """
    given = {key_of(name): value for name, value in look.items()}
    width, height = _size(ax, dots_per_inch)
    defaults: dict[str, Setting] = {"image.width": width, "image.height": height}
    if given.get("camera.projection") != "map":
        defaults["look.background"] = "transparent"
    if isinstance(what, (Run, Step)):
        if given or step is not None:
            raise ValueError("a Step is drawn as its scene says; set keys in the scene, or give the Scene")
        return _put(ax, next(what) if isinstance(what, Run) else what)
    if isinstance(what, Scene):
        scene = what.copy()
        scene.update({**defaults, **given})
    else:
        if step is not None:
            raise ValueError("heights have no steps")
        scene = Scene.from_toml('[model]\nname = "static"\n', bed=what, cell_size=cell_size, origin=origin, field=field,
                                **{**defaults, **given})
    return _put(ax, scene.at(step))


def _size(ax: Axes, dots_per_inch: float) -> tuple[int, int]:
    """Pixels of a picture that fills axes."""
    if not 0 < dots_per_inch <= 10000:
        raise ValueError(f"dots_per_inch is {dots_per_inch}; it takes a number above 0")
    box = ax.get_window_extent()
    scale = dots_per_inch / ax.figure.dpi
    return max(64, round(box.width * scale)), max(64, round(box.height * scale))


def _put(ax: Axes, step: Step) -> FigureAxes:
    shown = step._core.projection()
    extent, unit, crs = _extent(shown)
    pixels = step.image()
    if shown["is_map"]:
        left, top, wide, tall = shown["map_pixels"]
        west, east, south, north = extent
        x, y = (east - west) / wide, (north - south) / tall
        height, width = pixels.shape[:2]
        whole = (west - left * x, west + (width - left) * x, north - (height - top) * y, north + top * y)
        image = ax.imshow(pixels, extent=whole, origin="upper", aspect="equal")
        ax.set_xlim(west, east)
        ax.set_ylim(south, north)
    else:
        image = ax.imshow(pixels, extent=(0, pixels.shape[1], pixels.shape[0], 0), aspect="equal")
        ax.set_axis_off()
    unit_of_height = step.height_unit
    heights = step.bed if unit_of_height is None else step.bed * unit_of_height
    return FigureAxes(ax, image, extent, unit, crs, 1.0 if shown["is_map"] else shown["exaggeration"], shown, heights)


def _extent(shown: _core._Projection) -> tuple[tuple[float, float, float, float], str, str]:
    """West, east, south and north of the bed, their unit and reference system."""
    wide, tall = shown["extent"]
    place = shown["place"]
    if place is None:
        return (0.0, wide, 0.0, tall), "m" if shown["in_metres"] else "sites", ""
    west, south, x, y, degrees, crs = place
    return (west, west + wide * x, south, south + tall * y), "degrees" if degrees else "" if crs else "m", crs


def colormap(name: str) -> Any:
    """One of fumon's palettes ("batlow", "sand", "hypsometric" …; with "_r" reversed) as a colormap of Matplotlib, which from
    then on knows it as "fumon.batlow" too. InputError for an unknown one, ImportError without Matplotlib."""
    matplotlib: Any = importlib.import_module("matplotlib")
    colors: Any = importlib.import_module("matplotlib.colors")
    reverse = name.endswith("_r")
    colours = _core.palette(name[:-2] if reverse else name) / 255.0
    made = colors.ListedColormap(colours[::-1] if reverse else colours, f"fumon.{name}")
    if made.name not in matplotlib.colormaps:
        matplotlib.colormaps.register(made)
    return made
