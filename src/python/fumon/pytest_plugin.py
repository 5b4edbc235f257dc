"""Pictures under test: the pytest fixture ``fumon_image``.

    def test_hills(fumon_image):
        fumon_image(heights, cell_size=30, camera_azimuth=160)

    def test_barchans(fumon_image):
        fumon_image(fumon.Scene("barchans.toml"), step=400)

What is recorded of each picture stands in ``pictures.lock`` beside the test's file: ``pytest --fumon-update`` records.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator

import pytest

if TYPE_CHECKING:
    from . import _core
    from .images import Image

_key = pytest.StashKey["Session"]()


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("fumon", "fumon: pictures under test")
    group.addoption("--fumon-update", action="store_true", help="record the pictures as they are now")
    group.addoption("--fumon-pinned", action="store_true",
                    help="draw the same pixels on every x86-64 processor (as is done where they were recorded so)")
    group.addoption("--fumon-output", metavar="DIR", default="fumon-images",
                    help="folder for the page of pictures that differ (default fumon-images; not made if all pass)")


def pytest_configure(config: pytest.Config) -> None:
    if config.getoption("--fumon-update") and hasattr(config, "workerinput"):
        raise pytest.UsageError("--fumon-update records in one process; leave -n out")
    config.stash[_key] = Session(config)


def pytest_sessionfinish(session: pytest.Session) -> None:
    session.config.stash[_key].finish()


def pytest_terminal_summary(terminalreporter: Any, config: pytest.Config) -> None:
    for line in config.stash[_key].told:
        terminalreporter.write_line(line)


@pytest.fixture
def fumon_image(request: pytest.FixtureRequest) -> Iterator[Checker]:
    """Compares a picture with what is recorded of it; see Checker.__call__."""
    yield Checker(request.config.stash[_key], request.node)


class Session:
    """The locks, and the page of differences, of one run of pytest."""

    def __init__(self, config: pytest.Config) -> None:
        self.updates: bool = config.getoption("--fumon-update")
        worker = getattr(config, "workerinput", {}).get("workerid", "")
        folder = Path(config.getoption("--fumon-output"))
        self.folder = (folder if folder.is_absolute() else config.rootpath / folder) / worker
        self.told: list[str] = []
        self._pins: bool = config.getoption("--fumon-pinned")
        self._locks: dict[Path, dict[str, _core.Record]] = {}
        self._changed: set[Path] = set()
        self._page: _core.DifferencePage | None = None
        self._taken: set[tuple[Path, str]] = set()

    def take(self, lock: Path, name: str) -> None:
        """A name is that of one picture."""
        if (lock, name) in self._taken:
            raise ValueError(f"a picture before this one is called {name}, too; give this one a name=")
        self._taken.add((lock, name))
        self.page()  # which takes away that of an earlier run

    def records(self, lock: Path) -> dict[str, _core.Record]:
        from . import _core
        if lock not in self._locks:
            self._locks[lock] = _core.read_lock(str(lock))
            self._pin(any(record.pinned for record in self._locks[lock].values()))
        return self._locks[lock]

    def _pin(self, recorded: bool) -> None:
        from . import _core
        if not self._pins and not recorded:
            return
        try:
            _core.pin_rendering()
        except _core.Error as error:  # something was drawn before: the portable tier holds
            if self._pins:
                self.told.append(f"fumon: {error}")

    def record(self, lock: Path, name: str, record: _core.Record) -> None:
        before = self.records(lock).get(name)
        changes = "recorded; look at it before you keep it" if before is None else before.changes(record)
        if not changes:
            return
        self.told.append(f"fumon: {lock.parent.name}/{name}: {changes}")
        self._locks[lock][name] = record
        self._changed.add(lock)

    def page(self) -> _core.DifferencePage:
        from . import _core
        if self._page is None:
            self._page = _core.DifferencePage(str(self.folder))
        return self._page

    def finish(self) -> None:
        from . import _core
        for lock in sorted(self._changed):
            _core.write_lock(str(lock), self._locks[lock])
        if self._page is not None and self._page.finish():
            self.told.append(f"fumon: pictures that differ: {self._page.file}")


class Checker:
    """What the fixture ``fumon_image`` gives."""

    def __init__(self, session: Session, node: pytest.Item) -> None:
        self._session = session
        self._file = Path(node.path)
        self._name = node.name

    def __call__(self, subject: Any, *, step: int | None = None, name: str = "", picture: bool = False,
                 thumbnail_difference: float = 0.5, tile_ssim: float = 0.95, **look: Any) -> Image:
        """Fails unless the picture is as recorded, by the tiers of ``fumon verify``.

        subject: a Scene, which is run to ``step`` (the last one by default); a Step; a picture, as an array or a PNG
            file; or heights, which are drawn as render(subject, **look) draws them.
        name: of this picture, where a test has several.
        picture: keep the picture itself, too, beside the lock; its tiles are then compared.
        thumbnail_difference (grey levels), tile_ssim: what passes in the portable tier.

        Returns the picture.
        """
        from . import _core
        lock = self._file.parent / "pictures.lock"
        full = _good_name("-".join(part for part in (self._file.stem, self._name, name) if part))
        self._session.take(lock, full)
        recorded = self._session.records(lock).get(full)
        image, state = _drawn(subject, step, look)
        present = _core.Record(image, image.environment, state)
        kept = lock.with_suffix("") / f"{full}.png"
        if self._session.updates:
            self._session.record(lock, full, present)
            if picture:
                kept.parent.mkdir(exist_ok=True)
                image.save(kept)
            return image
        expected = _core.read_picture(os.fspath(kept)) if picture and kept.exists() else None
        outcome, finding = _core.judge(recorded, present, image, expected, picture, thumbnail_difference, tile_ssim)
        if outcome != "as recorded":
            if outcome == "missing":
                finding = "nothing is recorded; look at the picture, then `pytest --fumon-update`"
            page = self._session.page()
            page.add(self._file.stem, full, finding, image, recorded, expected)
            pytest.fail(f"{full}: {finding}\nsee {page.file}", pytrace=False)
        return image


def _drawn(subject: Any, step: int | None, look: dict[str, Any]) -> tuple[Image, str]:
    """The picture, and the hash of the state where a scene made it."""
    import numpy as np

    from .images import Image
    from .scene import Scene, Step
    from .terrain import render
    if isinstance(subject, Scene):
        scene = subject.copy()
        scene.update(look)
        run = scene.run(at=[scene["run.steps"] if step is None else step], measures=False, progress=False)
        return next(run).image(), run.state_hash
    if step is not None:
        raise TypeError("step is of a scene, which this is not")
    is_picture = getattr(subject, "dtype", None) == np.uint8 and getattr(subject, "ndim", 0) == 3
    if not (is_picture or isinstance(subject, (Step, str, os.PathLike))):
        return render(subject, **look), ""
    if look:
        raise TypeError(f"{next(iter(look))} changes what is drawn; this is drawn already")
    if isinstance(subject, Step):
        return subject.image(), ""
    if is_picture:
        return subject if isinstance(subject, Image) else Image(subject), ""
    return Image.open(subject), ""


def _good_name(text: str) -> str:
    return re.sub(r"[^A-Za-z0-9_-]+", "-", text).strip("-")[:100]
