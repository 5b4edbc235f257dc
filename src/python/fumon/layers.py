"""The light of a picture and what each of its pixels shows, as OpenEXR files hold them."""

from __future__ import annotations

import numpy as np

from .arrays import Floats


class Layers(dict[str, Floats]):
    """Channels of a picture by name, each float32 (height, width), top row first: "R", "G" and "B", linear light before
    exposure and tone curve; "A" where the background is transparent, by which they are multiplied; "Z", "normal.X",
    "position.X", "field.height" and others, as the guide's table in movies.md tells them. A dict in all it does."""

    units: dict[str, str]  #: of each channel; empty where it has none
    environment: str  #: what drew it, as one line of JSON

    @classmethod
    def drawn(cls, drawn: tuple[list[tuple[str, str, Floats]], str]) -> Layers:
        """What the core drew: each channel's name, unit and values, and what drew them."""
        channels, environment = drawn
        layers = cls({name: values for name, _, values in channels})
        layers.units = {name: unit for name, unit, _ in channels}
        layers.environment = environment
        return layers

    @property
    def light(self) -> Floats:
        """R, G, B as one array (height, width, 3)."""
        return np.stack([self["R"], self["G"], self["B"]], axis=-1)

    def __repr__(self) -> str:
        height, width = self["R"].shape
        return f"<fumon.Layers, {width} x {height} pixels: {', '.join(self)}>"
