"""The window of ``fumon view`` in a notebook."""

from __future__ import annotations

import atexit
import base64
import html
import os
import secrets
import socket
import weakref
from types import TracebackType
from typing import Union

from . import _core
from .arrays import Heights
from .images import PathLike
from .scene import Run, Scene
from .settings import Setting, settings_of
from .terrain import CellSize, Origin, held_bed

Viewed = Union[Scene, Run, PathLike, Heights]

_page = """<div id="{name}">
<div>{picture}
<p>Turn it at <a href="{url}" target="_blank" rel="noopener">{url}</a>. If the notebook runs on another machine, first, on your own:
<code>{forward}</code></p></div>
<iframe src="{url}" title="{alt}" style="position:absolute;width:1px;height:1px;border:0;opacity:0"></iframe>
<script>
addEventListener("message", (event) => {{
  const place = document.getElementById("{name}");
  const frame = place && place.querySelector("iframe");
  if (!frame || event.source !== frame.contentWindow || event.data !== "fumon view") return;
  place.firstElementChild.hidden = true;
  frame.style.cssText = "width:100%;height:{height}px;border:0";
}});
</script></div>"""


class View:
    """A viewer that runs in this process. A notebook shows its page where the browser reaches it, else a picture and the line
    of ``ssh`` that leads there. It ends by close(), with a ``with`` block, or with the process."""

    def __init__(self, core: _core.LiveView, name: str, height: int, held: _core.HeldBed | None = None) -> None:
        self._core, self._name, self._height, self._held = core, name, height, held
        atexit.register(_close, weakref.ref(self))

    @property
    def url(self) -> str:
        """The page's address, with its token: for a browser of this machine. Empty once it is closed."""
        return self._core.address

    @property
    def forward(self) -> str:
        """The line that brings the page to your own machine, where this is another one. Empty once it is closed."""
        if self.closed:
            return ""
        port = self.url.split(":")[2].split("/")[0]
        return f"ssh -L {port}:127.0.0.1:{port} {socket.gethostname()}"

    @property
    def closed(self) -> bool:
        """Whether the server has ended."""
        return self._core.closed

    def close(self) -> None:
        """Ends the server. Once more does nothing."""
        self._core.close()

    def __enter__(self) -> View:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()

    def _repr_html_(self) -> str:
        if self.closed:
            return html.escape(repr(self))
        picture = self._core.picture(640)
        kind = "png" if picture[1:4] == b"PNG" else "jpeg"
        shown = (f'<img alt="{html.escape(self._name)}" src="data:image/{kind};base64,{base64.b64encode(picture).decode()}" '
                 'style="max-width:100%">') if picture else "Nothing is computed yet."
        return _page.format(name=f"fumon-view-{secrets.token_hex(8)}", alt=html.escape(self._name), url=html.escape(self.url), height=self._height,
                            picture=shown, forward=html.escape(self.forward))

    def __repr__(self) -> str:
        return f"<fumon.View {self._name}: {'closed' if self.closed else self.url}>"


def _close(view: weakref.ref[View]) -> None:
    known = view()
    if known is not None:
        known.close()


def view(what: Viewed, cell_size: CellSize = None, *, origin: Origin = "lower", field: str | None = None, port: int = 0,
         height: int = 640, threads: int = 0, **look: Setting) -> View:
    """Shows a scene, a run or heights in a browser, to be turned, lit and played: the page of ``fumon view``.

    what: a Scene, or that of a Run, computed as far as one looks; the name of a scene, its file, the folder of a run,
        finished or not, NetCDF of another model, or a terrain file; or heights, as render() takes them with ``cell_size``, ``origin`` and ``field``.
    port: to listen on, of this machine alone; 0: one that is free. height: of the page in a notebook, pixels.
    threads: 0: one per processor. look: keys of the scene, as for render().

    Raises InputError where the scene, the run or a key is wrong, and where the port is taken.

        with fumon.view("terada-barchans") as window:
            print(window.url)
    """
    if not 0 <= port <= 65535:
        raise ValueError(f"port is 0 to 65535, not {port}")
    settings = settings_of(look)
    if isinstance(what, Run):
        what = what.scene
    if isinstance(what, (str, os.PathLike)):
        name = os.fspath(what)
        core = _core.LiveView.of_argument(name, [f"{key}={value}" for key, value in settings], port, threads)
        return View(core, name, height)
    if isinstance(what, Scene):
        scene = what.copy()
        scene._value.set(settings)
        name = str(scene["title"]) or "a scene"
        return View(_core.LiveView.of_scene(scene._value, name, port, threads), name, height, scene._bed)
    held = held_bed(what, cell_size, origin, field)
    value = _core.SceneValue.terrain([("bed.kind", '"file"'), ("bed.file", f'"{held.name}"'), *settings])
    return View(_core.LiveView.of_scene(value, "heights", port, threads), "heights", height, held)
