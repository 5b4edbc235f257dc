"""Python's keywords and values as the keys of a scene and their TOML."""

from __future__ import annotations

import json
import numbers
import os
from typing import Any, Iterable, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _core
from .map_layers import Features, map_layers

#: What a key is set to.
Setting = Union[str, "os.PathLike[str]", bool, int, float, np.generic, npt.NDArray[np.generic], Sequence["Setting"],
                Mapping[str, "Setting"], Features]


def key_of(name: str) -> str:
    """The key that a keyword means: "camera_azimuth" is camera.azimuth. Sections have no underscore in their names,
    so that the first one stands for the dot; a name with a dot is the key itself."""
    if "." in name or "_" not in name:
        return name
    section, rest = name.split("_", 1)
    return f"{section}.{rest}"


def toml_of(value: Any, key: str) -> str:
    """A value as TOML. TypeError for what no key takes."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, os.PathLike):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if hasattr(value, "tolist"):  # NumPy's arrays and numbers
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (list, tuple, range)):
        return "[" + ", ".join(toml_of(item, key) for item in value) + "]"
    raise TypeError(f"{key} takes a number, a text, a truth value or a list of them, not {type(value).__name__}")


def settings_of(given: Mapping[str, Setting]) -> list[tuple[str, str]]:
    """Keys with their values as TOML; a list of dicts (``overlay=[{"kind": "scale-bar"}]``) sets the keys of a list of
    sections, item by item. ``layers``: what lies over the bed, see map_layers()."""
    return [setting for name, value in given.items() for setting in _settings(*_section(name, value))]


def _section(name: str, value: Any) -> tuple[str, Any]:
    return ("layer", map_layers(value)) if name == "layers" else (key_of(name), value)


def look_settings(look: Mapping[str, Setting], colour: str | None) -> list[str]:
    """``key=VALUE`` of a look, with what ``colour`` names to colour the ground, which keys of the look change further."""
    return _core.colour_settings(colour or "") + [f"{key}={value}" for key, value in settings_of(look)]


def _settings(key: str, value: Setting) -> Iterable[tuple[str, str]]:
    if isinstance(value, Mapping):
        for name, inner in value.items():
            yield from _settings(f"{key}.{name}", inner)
    elif isinstance(value, (list, tuple)) and value and all(isinstance(item, Mapping) for item in value):
        for index, item in enumerate(value):
            yield from _settings(f"{key}.{index}", item)
    else:
        yield key, toml_of(value, key)
