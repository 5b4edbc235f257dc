"""Pictures: arrays that show themselves, and how alike two of them are."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, TypedDict, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Array, Bytes, Numbers

PathLike = Union[str, "os.PathLike[str]"]
Picture = Union[PathLike, npt.ArrayLike]  #: a PNG file or pixels
Likeness = Literal["identical", "same to the eye", "close", "different"]


if TYPE_CHECKING:
    _Pixels = npt.NDArray[Any]
else:
    _Pixels = np.ndarray


class Image(_Pixels):
    """A picture: uint8 (height, width, 3), top row first; (height, width, 4) where it has alpha, by which colours are not
    multiplied. A NumPy array in all it does; notebooks show it. A number reckoned of it (``image.mean()``) is NumPy's."""

    environment: str  #: what drew it, as one line of JSON; empty where that is not known

    def __new__(cls, pixels: npt.ArrayLike) -> Image:
        return checked_pixels(pixels).view(cls)

    def __array_finalize__(self, other: Any) -> None:
        self.environment = ""

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        """What NumPy reckons of an array; as a picture again where it has dimensions, in which NumPy's own subclasses
        would keep a single number, too."""
        given: tuple[Any, ...] = options.get("out", (None,) * ufunc.nout)
        if "out" in options:
            options["out"] = tuple(_plain(one) for one in given)
        if "where" in options:
            options["where"] = _plain(options["where"])
        result = getattr(ufunc, method)(*(_plain(one) for one in inputs), **options)
        if isinstance(result, tuple):
            return tuple(self._again(one) if own is None else own for one, own in zip(result, given))
        return self._again(result) if given[0] is None else given[0]

    def _again(self, result: Any) -> Any:
        return result.view(type(self)) if type(result) is np.ndarray and result.ndim > 0 else result

    def __copy__(self) -> Image:
        return self.__deepcopy__()

    def __deepcopy__(self, memo: dict[int, Any] | None = None) -> Image:
        return _image_of(type(self), np.array(self), self.environment)

    def __reduce__(self) -> tuple[Any, ...]:
        return _image_of, (type(self), np.array(self), self.environment)

    @classmethod
    def drawn(cls, drawn: tuple[Bytes, str]) -> Image:
        """What the core drew: the pixels, and what drew them."""
        image = drawn[0].view(cls)
        image.environment = drawn[1]
        return image

    @classmethod
    def open(cls, file: PathLike) -> Image:
        """The pixels of a PNG, JPEG, WebP or TIFF file, with alpha where it has some."""
        return _core.read_picture(os.fspath(file)).view(cls)

    def save(self, file: PathLike, quality: int = 92, lossless: bool = False) -> None:
        """Writes it whole or not at all, as PNG, JPEG (.jpg, .jpeg) or WebP by the file's name. ``quality``, 1 … 100, is of
        JPEG and WebP, ``lossless`` of WebP. JPEG has no alpha: what can be seen through stands on white."""
        name = picture_name(file)
        if not 1 <= quality <= 100:
            raise ValueError(f"quality is {quality}; it takes 1 … 100")
        _core.write_file(name, _core.encoded(checked_pixels(self), name, quality=quality, lossless=lossless))

    def _repr_png_(self) -> bytes | None:
        is_picture = self.ndim == 3 and self.shape[2] in (3, 4) and self.dtype == np.uint8 and self.size > 0
        return _core.encoded(np.ascontiguousarray(self)) if is_picture else None

    def __repr__(self) -> str:
        if self.ndim != 3:
            return super().__repr__()
        return f"<fumon.Image, {self.shape[1]} x {self.shape[0]} pixels>"


def _plain(thing: Any) -> Any:
    return thing.view(np.ndarray) if isinstance(thing, Image) else thing


def _image_of(kind: type[Image], pixels: Array, environment: str) -> Image:
    image: Image = pixels.view(kind)
    image.environment = environment
    return image


def picture_name(file: PathLike) -> str:
    """The name of a file for a picture. ValueError where it ends otherwise."""
    name = os.fspath(file)
    if not name.lower().endswith((".png", ".jpg", ".jpeg", ".webp", ".tif", ".tiff")):
        raise ValueError(f"{name}: pictures are PNG, JPEG, WebP or TIFF files; write {name}.png")
    return name


def checked_pixels(pixels: npt.ArrayLike) -> Bytes:
    """Pixels as they come, as a packed array. TypeError and ValueError for what is no picture."""
    array = np.asarray(pixels)
    if array.dtype != np.uint8:
        raise TypeError(f"a picture has levels of 8 bits (uint8), not {array.dtype}")
    if array.ndim != 3 or array.shape[2] not in (3, 4) or array.size == 0:
        raise ValueError(f"a picture is an array (height, width, 3), with alpha (height, width, 4), not {array.shape}")
    return np.ascontiguousarray(array)


def _pixels_of(picture: Picture) -> Bytes:
    if isinstance(picture, (str, os.PathLike)):
        return _core.read_picture(os.fspath(picture))
    return checked_pixels(picture)


@dataclass(frozen=True)
class Comparison:
    """How far two pictures are apart, as ``fumon compare`` says it."""

    likeness: Likeness
    largest: int  #: difference of a level, 0 … 255
    changed: int  #: pixels
    changed_share: float
    mean: float  #: difference of a level, over all levels of all pixels
    tile_ssim: float  #: of the least similar 8 x 8 tile (Wang et al. 2004)
    thumbnail: float  #: largest difference of 32 x 18 box means, grey levels
    difference: Image = field(repr=False, compare=False)  #: the first one in grey, what changed over it in red


class Fingerprint(TypedDict):
    """What is told of a picture by fingerprint()."""

    width: int  #: pixels
    height: int
    pixels_sha256: str
    dhash: str
    thumbnail: Numbers  #: (18, 32, 3), means of boxes


def compare(first: Picture, second: Picture) -> Comparison:
    """Compares two pictures of one size: arrays or files (PNG, JPEG, WebP); what is transparent on black and on white, whichever tells
    them further apart. ValueError where their sizes differ."""
    a, b = _pixels_of(first), _pixels_of(second)
    return Comparison(**_core.compare(a, b), difference=_core.difference(a, b).view(Image))


def fingerprint(picture: Picture) -> Fingerprint:
    """What ``fumon fingerprint`` says of a picture, an array or a file (PNG, JPEG, WebP): width and height (pixels), pixels_sha256,
    dhash and thumbnail, an array (18, 32, 3) of box means."""
    return _core.fingerprint(_pixels_of(picture))
