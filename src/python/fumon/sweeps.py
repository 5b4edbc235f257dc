"""A sweep as a Dataset."""

from __future__ import annotations

import contextlib
import os
import tempfile
import warnings
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Sequence, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .arrays import Array
from .images import PathLike
from .progress import Progress
from .settings import Setting, key_of, toml_of

if TYPE_CHECKING:
    import xarray

Keys = TypeVar("Keys", bound=Union[str, "tuple[str, ...]"])
_Values = Union[Sequence[Setting], npt.NDArray[np.generic]]
#: Values by key, or by keys that go together.
Over = Mapping[Keys, _Values]


def sweep(scene: _core.SceneValue, over: Over[Keys] | None, seeds: int | range | None, folder: PathLike | None, threads: int,
          progress: bool | None) -> xarray.Dataset:
    """See Scene.sweep()."""
    import xarray  # noqa: F401  before hours of work

    axes = {_keys(names): list(values) for names, values in (over or {}).items()}
    for keys, values in axes.items():
        if not values:
            raise ValueError(f"{keys[0]} has no values to take")
    texts = ["+".join(keys) + "=" + ",".join(toml_of(value, keys[0]) for value in values)
             for keys, values in axes.items()]
    with Progress(1, "runs", progress) as shown, _folder(folder) as place:
        def tell(done: int, total: int) -> None:
            shown.total = total
            shown.tell(done)

        result = _core.sweep(scene, texts, _seeds(seeds), place, threads, tell)
    names = [names if isinstance(names, str) else names[0] for names in over] if over else None
    return _dataset(result, names, list(axes.values()))


def _keys(names: str | tuple[str, ...]) -> tuple[str, ...]:
    return tuple(key_of(name) for name in ((names,) if isinstance(names, str) else names))


def _seeds(seeds: int | range | None) -> str:
    if seeds is None:
        return ""
    if isinstance(seeds, range):
        if seeds.step != 1 or len(seeds) == 0:
            raise ValueError(f"seeds are a range of following numbers, not {seeds}")
        return f"{seeds.start}:{seeds.stop - 1}"
    return str(int(seeds))


@contextlib.contextmanager
def _folder(folder: PathLike | None) -> Iterator[str]:
    if folder is not None:
        yield os.fspath(folder)
        return
    with tempfile.TemporaryDirectory(prefix="fumon-sweep-") as place:
        yield place


def _dataset(result: _core._Swept, names: list[str] | None, values: list[list[Any]]) -> xarray.Dataset:
    import xarray

    if names is None:  # the scene's own sweep
        names = [keys[0] for keys, _ in result["axes"]]
        values = [[_number(text) for text in texts] for _, texts in result["axes"]]
    runs = result["runs"]
    seeds = sorted({run["seed"] for run in runs})
    steps = np.unique(np.concatenate([run["columns"].get("step", np.empty(0)) for run in runs])).astype(np.int64)
    sizes = [len(one) for one in values]
    columns = [name for name in dict.fromkeys(name for run in runs for name in run["columns"]) if name != "step"]
    arrays = {name: np.full((*sizes, len(seeds), len(steps)), np.nan) for name in columns}
    states = np.full((*sizes, len(seeds)), "", dtype=object)
    for run in runs:
        place: Any = (*np.unravel_index(run["combination"], sizes or [1])[:len(sizes)], seeds.index(run["seed"]))
        states[place] = run["state"]
        if not run["done"]:
            warnings.warn(f"a run failed (combination {run['combination'] + 1}, seed {run['seed']}): {run['message']}",
                          stacklevel=5)
            continue
        if run["message"]:
            warnings.warn(f"combination {run['combination'] + 1}, seed {run['seed']}: {run['message']}", stacklevel=5)
        rows = np.searchsorted(steps, run["columns"]["step"].astype(np.int64))
        for name, column in run["columns"].items():
            if name != "step":
                arrays[name][place][rows] = column
    dims = (*names, "seed", "step")
    variables = {name: (dims, array, _attributes(result["columns"].get(name))) for name, array in arrays.items()}
    variables["state_sha256"] = (dims[:-1], states.astype(str), {"long_name": "SHA-256 of the final state"})
    coordinates = {name: (name, _coordinate(one)) for name, one in zip(names, values)}
    return xarray.Dataset(variables, {**coordinates, "seed": seeds, "step": steps},
                          {"source": f"fumon {_core.version}"})


def _attributes(column: tuple[str, str] | None) -> dict[str, str]:
    return {} if column is None else {"units": column[0] or "1", "long_name": column[1]}


def _coordinate(values: list[Any]) -> Array:
    """Numbers and texts as they are; lists as their text."""
    if all(isinstance(value, (bool, int, float, str, np.generic)) for value in values):
        return np.array(values)
    return np.array([str(value) for value in values])


def _number(text: str) -> Any:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
