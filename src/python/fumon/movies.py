"""Movies of pictures, of a run's steps or of beds."""

from __future__ import annotations

import base64
import html
import os
from pathlib import Path
from typing import Any, Iterable, Iterator, Mapping, Union

import numpy as np

from . import _core
from .arrays import Bytes, Dataset, Heights
from .images import Image, PathLike, checked_pixels
from .progress import Progress
from .scene import Run, Step
from .settings import Setting
from .terrain import CellSize, Origin, Painter, bed_of, ordered_dims

_types = {".mp4": "video/mp4", ".webm": "video/webm", ".gif": "image/gif", ".webp": "image/webp", ".apng": "image/apng"}
_largest_embedded = 64_000_000  # bytes


Frames = Union[Run, Step, Iterable[Union[Step, Heights]], Heights, Dataset]


class Movie:
    """A movie file. A notebook shows it, from its own bytes."""

    file: Path
    width: int  #: pixels
    height: int
    frames: int
    rate: float  #: frames a second

    def __init__(self, file: PathLike, width: int, height: int, frames: int, rate: float) -> None:
        self.file = Path(file)
        self.width, self.height, self.frames, self.rate = width, height, frames, rate

    def _repr_html_(self) -> str:
        kind = _types.get(self.file.suffix)
        if kind is None or self.file.stat().st_size > _largest_embedded:
            return html.escape(str(self.file))
        data = f"data:{kind};base64,{base64.b64encode(self.file.read_bytes()).decode()}"
        if kind.startswith("image/"):
            return f'<img src="{data}" style="max-width:100%">'
        return f'<video controls loop style="max-width:100%" src="{data}"></video>'

    def __repr__(self) -> str:
        return f"<fumon.Movie {self.file}: {self.frames} frames, {self.width} x {self.height} pixels, {self.rate:g} a second>"


def movie(frames: Frames, file: PathLike, *, rate: float = 30.0, quality: int = 18, cell_size: CellSize = None,
          origin: Origin = "lower", variable: str | None = None, progress: bool | None = None,
          **look: Setting) -> Movie:
    """Writes a movie; the ending of ``file`` says which kind (.mp4, .webm, .gif, .webp, .apng, .mov, .mkv).

    frames: a run (``scene.run(every=10)``) or its steps; pictures; or beds to be drawn as render() draws them, framed
        by the first: an array (n, ny, nx), a list of arrays, an xarray.DataArray with one dimension more, or a
        Dataset, of which ``variable`` names the heights ("bed_height" of a run's fields.nc, "bed", or the only one with three dimensions).
        Pictures with alpha keep it in .mov, .mkv, .webp and .apng, and stand on white in the others.
    rate: frames a second. quality: constant rate factor, 0 (best) to 51. cell_size, origin, look: as for render().
    """
    if not (0.0 < rate <= 1000.0):
        raise ValueError(f"rate is frames a second, above 0 and up to 1000, not {rate}")
    if not 0 <= quality <= 51:
        raise ValueError(f"quality is 0 (best) to 51, not {quality}")
    name = os.fspath(file)
    writer = _core.MovieWriter(name, float(rate), int(quality))
    painter = Painter(look)
    size, count = None, 0
    items, total = _items(frames, variable)
    with Progress(total, "frames", progress if total else False) as shown:
        for item in items:
            picture = _picture(item, painter, cell_size, origin, look)
            if size is not None and picture.shape[:2] != size:
                raise ValueError(f"frame {count} has {picture.shape[1]} x {picture.shape[0]} pixels, the first "
                                 f"{size[1]} x {size[0]}")
            size = picture.shape[:2]
            writer.add(picture)
            count += 1
            shown.tell(count)
    if size is None:
        raise ValueError("a movie needs a frame")
    writer.finish()
    return Movie(name, size[1], size[0], count, float(rate))


def _items(frames: Any, variable: str | None) -> tuple[Iterator[Any], int]:
    if isinstance(frames, Step):
        return iter([frames]), 0
    if isinstance(frames, Run):
        return frames, 0
    if hasattr(frames, "data_vars"):
        frames = frames[variable or _heights_of(frames)]
    elif variable is not None:
        raise ValueError("variable names the heights of a Dataset, which this is not")
    if hasattr(frames, "dims") and hasattr(frames, "coords"):
        over = [dim for dim in frames.dims if dim not in ordered_dims(frames) and frames.sizes[dim] > 1]
        if len(over) != 1:
            raise ValueError(f"a movie's heights have three dimensions, not {tuple(frames.dims)}")
        return (frames.isel({over[0]: index}) for index in range(frames.sizes[over[0]])), frames.sizes[over[0]]
    if isinstance(frames, np.ndarray) and frames.ndim < 3:
        raise ValueError(f"a movie's heights are an array (n, ny, nx), not {frames.shape}")
    return iter(frames), len(frames) if hasattr(frames, "__len__") else 0


def _heights_of(dataset: Any) -> str:
    for name in ("bed_height", "bed"):
        if name in dataset.data_vars:
            return name
    names = [str(name) for name, values in dataset.data_vars.items() if values.ndim == 3]
    if len(names) != 1:
        raise ValueError(f"which variable holds the heights? variable= one of {', '.join(names) or 'none has three dimensions'}")
    return names[0]


def _picture(item: Any, painter: Painter, cell_size: CellSize, origin: Origin, look: Mapping[str, Setting]) -> Bytes:
    is_picture = isinstance(item, Image) or (getattr(item, "dtype", None) == np.uint8 and getattr(item, "ndim", 0) == 3)
    if (is_picture or isinstance(item, Step)) and look:
        raise TypeError(f"{next(iter(look))} changes beds that are drawn; these are pictures, or steps with a scene")
    if isinstance(item, Step):
        return item.image()
    if is_picture:
        return checked_pixels(item)
    return painter.draw(bed_of(item, cell_size, origin))
