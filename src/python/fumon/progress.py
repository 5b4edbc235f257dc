"""How far a run or a sweep is, on a terminal or in a notebook; no server, nothing to install."""

from __future__ import annotations

import importlib
import sys
import time
from types import TracebackType

_between_looks = 0.2  # seconds


def _in_notebook() -> bool:
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and getattr(shell, "kernel", None) is not None


class Progress:
    """Tells how much of ``total`` is done. ``wanted`` None: on a terminal and in a notebook alone."""

    def __init__(self, total: int, unit: str, wanted: bool | None = None) -> None:
        self.total: int = total
        self._unit = unit
        self._notebook = _in_notebook()
        self._on = wanted if wanted is not None else self._notebook or sys.stderr.isatty()
        self._began = self._shown = time.monotonic()
        self._handle: object | None = None
        self._open = False

    def __enter__(self) -> Progress:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def tell(self, done: int) -> None:
        """Shows it if it is time to."""
        now = time.monotonic()
        if not self._on or now - self._shown < _between_looks:
            return
        self._shown = now
        seconds = now - self._began
        left = f", {seconds * (self.total - done) / done:.0f} s left" if done > 0 else ""
        text = f"{done} of {self.total} {self._unit}{left}"
        if self._notebook:
            self._show_in_notebook(done, text)
        else:
            sys.stderr.write("\r\033[K" + text)
            sys.stderr.flush()
        self._open = True

    def close(self) -> None:
        """Takes it away."""
        if not self._open:
            return
        self._open = False
        if self._notebook:
            self._show_in_notebook(self.total, "")
        else:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()

    def _show_in_notebook(self, done: int, text: str) -> None:
        ipython = importlib.import_module("IPython.display")
        page = ipython.HTML(f"<progress value='{done}' max='{max(self.total, 1)}'></progress> {text}" if text else "")
        if self._handle is None:
            self._handle = ipython.display(page, display_id=True)
        else:
            self._handle.update(page)  # type: ignore[attr-defined]
