"""Lines, points and areas over a bed, given to Python, as the sections [[layer]] of a scene."""

from __future__ import annotations

import atexit
import hashlib
import json
import os
import re
import shutil
import tempfile
from pathlib import Path
from typing import Any, Iterable, Mapping, Protocol, runtime_checkable

_of_geojson = {"Feature", "FeatureCollection", "Point", "MultiPoint", "LineString", "MultiLineString", "Polygon",
               "MultiPolygon", "GeometryCollection"}
# "EPSG:4326", an URN or address, WKT, PROJ, PROJJSON, "WGS84"
_system = re.compile(r"\w+:.+|[A-Z_]+\[|\+|\{|(WGS|NAD|CRS)\d\d$")
_kept: dict[int, str] = {}  # the folder of a process: one that was forked leaves its parent's alone


@runtime_checkable
class Features(Protocol):
    """What holds geometries as GeoJSON has them: a GeoDataFrame, a GeoSeries, a geometry of Shapely."""

    @property
    def __geo_interface__(self) -> Any:
        """The features as a mapping."""


def map_layers(given: Any) -> list[dict[str, Any]]:
    """The keys of each layer ([[layer]]): of one, or of a list of them, each a file, features, or a mapping of those keys,
    whose ``file`` may be features too. TypeError for what is none of these."""
    is_one = isinstance(given, (str, os.PathLike, Mapping, Features)) or not isinstance(given, Iterable)
    return [_layer(layer) for layer in ([given] if is_one else given)]


def _layer(layer: Any) -> dict[str, Any]:
    if isinstance(layer, Mapping) and not _is_geojson(layer):
        return {key: _file(value) if key == "file" else value for key, value in layer.items()}
    return {"file": _file(layer)}


def _file(given: Any) -> str:
    if isinstance(given, (str, os.PathLike)):
        return os.fspath(given)
    if isinstance(given, Mapping) and _is_geojson(given):
        return _kept_file(given)
    if isinstance(given, Features):
        features = given.__geo_interface__
        if features["type"] == "LinearRing":  # of Shapely, which GeoJSON does not know
            features = {**features, "type": "LineString"}
        return _kept_file(_with_system(features, given))
    raise TypeError(f"a layer is a file, features (GeoJSON, a GeoDataFrame) or a mapping of the keys of [[layer]], "
                    f"not {type(given).__name__}")


def _is_geojson(given: Mapping[Any, Any]) -> bool:
    return given.get("type") in _of_geojson


def _with_system(features: Mapping[str, Any], owner: Any) -> Mapping[str, Any]:
    """With the owner's reference system, which GeoJSON of today leaves out; where it has none they are longitudes and latitudes."""
    system = getattr(owner, "crs", None)
    if system is None:
        return features
    if features["type"] not in ("Feature", "FeatureCollection"):
        features = {"type": "Feature", "properties": {}, "geometry": features}
    authority = system.to_authority() if hasattr(system, "to_authority") else None
    name = ":".join(authority) if authority else system.to_wkt() if hasattr(system, "to_wkt") else str(system)
    if not _system.match(name):
        raise ValueError(f"the layer's crs {name!r} is no reference system; set one such as \"EPSG:32613\"")
    return {**features, "crs": {"type": "name", "properties": {"name": name}}}


def _kept_file(features: Mapping[str, Any]) -> str:
    """A file of the features, until the process ends."""
    text = json.dumps(features, default=_plain)
    process = os.getpid()
    if process not in _kept:
        _kept[process] = tempfile.mkdtemp(prefix="fumon-layers-")
        atexit.register(_remove, process)
    file = Path(_kept[process]) / f"{hashlib.sha256(text.encode()).hexdigest()[:16]}.geojson"
    file.write_text(text, encoding="utf-8")
    return str(file)


def _remove(process: int) -> None:
    if os.getpid() == process:
        shutil.rmtree(_kept[process], ignore_errors=True)


def _plain(value: Any) -> Any:
    if isinstance(value, Features):
        return value.__geo_interface__
    if hasattr(value, "tolist"):  # NumPy's arrays and numbers
        return value.tolist()
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, Iterable) and not isinstance(value, (str, bytes)):
        return list(value)
    return str(value)
