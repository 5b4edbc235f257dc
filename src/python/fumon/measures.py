"""What was measured of a bed."""

from __future__ import annotations

import html
from typing import Iterable


class Measures(dict[str, float]):
    """Measures by name; NaN is what has no meaning for this bed. ``units`` and ``help`` say, by the same names, in
    what unit each is and how it is defined."""

    units: dict[str, str]
    help: dict[str, str]

    def __init__(self, measured: Iterable[tuple[str, float, str, str]] = ()) -> None:
        rows = list(measured)
        super().__init__((name, value) for name, value, _, _ in rows)
        self.units = {name: unit for name, _, unit, _ in rows}
        self.help = {name: text for name, _, _, text in rows}

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{name}</td><td>{value:.6g}</td><td>{html.escape(self.units[name])}</td>"
            f"<td style='text-align:left'>{html.escape(self.help[name])}</td></tr>"
            for name, value in self.items())
        return f"<table><tr><th>measure</th><th>value</th><th>unit</th><th>definition</th></tr>{rows}</table>"
