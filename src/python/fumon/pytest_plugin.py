"""Pictures under test: the pytest fixture ``fumon_image``.

    def test_hills(fumon_image):
        fumon_image(heights, cell_size=30, camera_azimuth=160)

    def test_barchans(fumon_image):
        fumon_image(fumon.Scene("barchans.toml"), step=400)

What is recorded of each picture stands in ``pictures.lock`` beside the test's file: ``pytest --fumon-update`` records.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Sequence

import pytest

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from _pytest.terminal import TerminalReporter

    from . import _core
    from .arrays import Heights
    from .images import Image, Picture
    from .scene import Scene, Step
    from .settings import Setting

_key = pytest.StashKey["Session"]()


def pytest_addoption(parser: pytest.Parser) -> None:
    """The options of pictures under test."""
    group = parser.getgroup("fumon", "fumon: pictures under test")
    group.addoption("--fumon-update", action="store_true", help="record the pictures as they are now")
    group.addoption("--fumon-pinned", action="store_true",
                    help="draw the same pixels on every x86-64 processor with SSE4.1 (as is done where they were recorded so)")
    group.addoption("--fumon-output", metavar="DIR", default="fumon-images",
                    help="folder for the page of pictures that differ (default fumon-images; not made if all pass)")


def pytest_configure(config: pytest.Config) -> None:
    """Makes ready what a run of pytest keeps."""
    session = config.stash[_key] = Session(config)
    config.pluginmanager.register(session.whole)
    if config.getoption("numprocesses", None):
        session.clear_pages()
        config.pluginmanager.register(OtherProcesses(session))


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Writes the locks and the page."""
    ours = session.config.stash[_key]
    ours.finish()
    if hasattr(session.config, "workeroutput"):  # pytest-xdist: only the process that started this one has a terminal
        session.config.workeroutput["fumon"] = ours.told


def pytest_terminal_summary(terminalreporter: TerminalReporter, config: pytest.Config) -> None:
    """Says what was recorded, and where the page is."""
    for line in config.stash[_key].told:
        terminalreporter.write_line(line)


@pytest.fixture
def fumon_image(request: pytest.FixtureRequest) -> Iterator[Checker]:
    """Compares a picture with what is recorded of it; see Checker.__call__."""
    yield Checker(request.config.stash[_key], request.node)


class Session:
    """The locks, and the page of differences, of one run of pytest."""

    updates: bool
    folder: Path  #: of the page
    told: list[str]  #: lines for the terminal
    whole: WholeFiles

    def __init__(self, config: pytest.Config) -> None:
        self.updates = bool(config.getoption("--fumon-update"))
        worker = getattr(config, "workerinput", {}).get("workerid", "")
        folder = Path(config.getoption("--fumon-output"))
        self.folder = (folder if folder.is_absolute() else config.rootpath / folder) / worker
        self.told = []
        self._pins: bool = config.getoption("--fumon-pinned")
        self._locks: dict[Path, dict[str, _core.Record]] = {}
        self._recorded: dict[Path, dict[str, _core.Record]] = {}  # by this process, still to be written
        self._removed: dict[Path, set[str]] = {}
        self._page: _core.DifferencePage | None = None
        self._taken: set[tuple[Path, str]] = set()
        self.whole = WholeFiles(config)

    def take(self, lock: Path, name: str) -> None:
        """A name is that of one picture."""
        if (lock, name) in self._taken:
            raise ValueError(f"a picture before this one is called {name}, too; give this one a name=")
        self._taken.add((lock, name))
        self.page()  # which takes away that of an earlier run

    def keep(self, lock: Path, name: str) -> None:
        """A record that is in use."""
        self._taken.add((lock, name))

    def records(self, lock: Path) -> dict[str, _core.Record]:
        """What a lock holds, by the pictures' names."""
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
        """Takes a picture into its lock, which finish() writes."""
        before = self.records(lock).get(name)
        changes = "recorded; look at it before you keep it" if before is None else before.changes(record)
        if not changes:
            return
        self.told.append(f"fumon: {lock.parent.name}/{name}: {changes}")
        self._locks[lock][name] = record
        self._recorded.setdefault(lock, {})[name] = record

    def clear_pages(self) -> None:
        """Takes away the pages of an earlier run, of all its processes."""
        from . import _core
        for folder in (self.folder, *self.folder.glob("gw*")):
            if (folder / "index.html").exists():
                _core.DifferencePage(str(folder)).finish()

    def page(self) -> _core.DifferencePage:
        """The page of pictures that differ."""
        from . import _core
        if self._page is None:
            self._page = _core.DifferencePage(str(self.folder))
        return self._page

    def finish(self) -> None:
        """Writes the locks that changed, and the page if it has a picture."""
        for lock in sorted(self._locks):
            self._look_for_gone(lock)
        for lock in sorted({*self._recorded, *self._removed}):
            self._write(lock)
        if self._page is not None and self._page.finish():
            self.told.append(f"fumon: pictures that differ: {self._page.file}")

    def _write(self, lock: Path) -> None:
        """Brings into a lock what this process recorded and removed; another may have written it since it was read."""
        from . import _core
        with _alone_in(lock.parent):
            records = _core.read_lock(str(lock))
            records.update(self._recorded.get(lock, {}))
            for name in self._removed.get(lock, ()):
                records.pop(name, None)
            _core.write_lock(str(lock), records)

    def _look_for_gone(self, lock: Path) -> None:
        """Records that no test draws any more: told and, where records are taken, removed."""
        taken = {name for at, name in self._taken if at == lock}
        for name in sorted(set(self._locks[lock]) - taken):
            if not self.whole.is_gone(lock.parent, name):
                continue
            if not self.updates:
                self.told.append(f"fumon: {lock.parent.name}/{name}: is recorded, and no test draws it; --fumon-update removes it")
                continue
            self.told.append(f"fumon: {lock.parent.name}/{name}: removed, as no test draws it")
            del self._locks[lock][name]
            self._recorded.get(lock, {}).pop(name, None)
            self._removed.setdefault(lock, set()).add(name)
            kept_picture(lock, name).unlink(missing_ok=True)


class OtherProcesses:
    """The processes of pytest-xdist, which have no terminal."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def pytest_testnodedown(self, node: Any, error: object) -> None:
        """Takes over what a process that ended has to say."""
        self._session.told += getattr(node, "workeroutput", {}).get("fumon", [])


class WholeFiles:
    """The files all of whose tests ran and passed, so that what they did not draw is drawn no more."""

    def __init__(self, config: pytest.Config) -> None:
        self._in_part = hasattr(config, "workerinput") or any(
            config.getoption(name, None) for name in ("numprocesses", "lf"))
        here = config.invocation_params.dir
        self._parts = {(here / argument.split("::")[0]).resolve() for argument in config.args if "::" in argument}
        self._waiting: dict[str, Path] = {}
        self._files: dict[Path, bool] = {}

    def pytest_collection_finish(self, session: pytest.Session) -> None:
        """Notes the tests that are to run."""
        self._waiting = {item.nodeid: Path(item.path) for item in session.items}
        for path in self._waiting.values():
            self._files.setdefault(path, path.resolve() not in self._parts)

    def pytest_deselected(self, items: list[pytest.Item]) -> None:
        """Notes the files of which not every test runs."""
        for item in items:
            self._files[Path(item.path)] = False

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Notes a test that ran; one that was skipped or failed draws what it draws another time."""
        path = self._waiting.get(report.nodeid)
        if path is None:
            return
        if not report.passed:
            self._files[path] = False
        elif report.when == "teardown":
            del self._waiting[report.nodeid]

    def is_gone(self, folder: Path, name: str) -> bool:
        """Whether a record that was not drawn is of a test that is no more."""
        if self._in_part:
            return False
        stems = [_good_name(file.stem) for file in folder.glob("*.py")]
        owner = max((stem for stem in stems if name.startswith(f"{stem}-")), key=len, default=None)
        if owner is None:  # the file is gone
            return True
        return any(is_whole and path.parent == folder and _good_name(path.stem) == owner and path not in self._waiting.values()
                   for path, is_whole in self._files.items())


class Checker:
    """What the fixture ``fumon_image`` gives."""

    def __init__(self, session: Session, node: pytest.Item) -> None:
        self._session = session
        self._file = Path(node.path)
        self._name = node.name
        self._classes = [part.name for part in node.listchain() if isinstance(part, pytest.Class)]

    def __call__(self, subject: Scene | Step | Picture | Heights, *, step: int | None = None, name: str = "",
                 picture: bool = False, heights: bool = False, exact: bool = False,
                 thumbnail_difference: float = 0.5, tile_ssim: float = 0.95,
                 ignore: Sequence[tuple[int, int, int, int]] = (),
                 ignore_mask: npt.NDArray[Any] | str | os.PathLike[str] | None = None, **look: Setting) -> Image:
        """Fails unless the picture is as recorded, by the tiers of ``fumon verify``.

        subject: a Scene, which is run to ``step`` (the last one by default); a Step; a picture, as an array of uint8,
            (height, width) where it is grey, or a PNG file; or heights, which are drawn as render(subject, **look)
            draws them.
        heights: take an array of uint8 (ny, nx) for heights, too.
        name: of this picture, where a test has several.
        picture: keep the picture itself, too, beside the lock; its tiles are then compared.
        exact: every pixel must be as recorded, as for arrays of your own that are the same everywhere.
        thumbnail_difference (grey levels), tile_ssim: what passes in the portable tier.
        ignore: boxes (x, y, width, height) of pixels from the upper left corner that are left out.
        ignore_mask: an array (height, width), true or at least 128 where the picture is left out, or a PNG file that is white there.
            At most 30 % of a picture may be left out.

        Returns the picture.
        """
        from . import _core
        lock = self._file.parent / "pictures.lock"
        full = _good_name("-".join(part for part in (self._file.stem, *self._classes, self._name, name) if part))
        self._session.take(lock, full)
        records = self._session.records(lock)
        # Before fumon 0.3 names had no class, and long ones were cut off.
        former = _plain_name("-".join(part for part in (self._file.stem, self._name, name) if part))[:100]
        known = former if full not in records and former in records else full
        recorded = records.get(known)
        image, state = _drawn(subject, step, heights, look)
        ignored = _core.IgnoredPixels(image, ignore, _mask(ignore_mask))
        present = _core.Record(image, image.environment, state, ignored)
        if self._session.updates:
            self._session.record(lock, full, present)
            if picture:
                kept = kept_picture(lock, full)
                kept.parent.mkdir(exist_ok=True)
                image.save(kept)
            return image
        self._session.keep(lock, known)
        kept = kept_picture(lock, known)
        expected = _core.read_picture(os.fspath(kept)) if picture and kept.exists() else None
        outcome, finding = _core.judge(recorded, present, image, expected, picture, thumbnail_difference, tile_ssim, ignored)
        if exact and recorded is not None and outcome == "as recorded" and recorded.pixels != present.pixels:
            outcome, finding = "differs", f"exact: {finding}"
        if outcome != "as recorded":
            if outcome == "missing":
                finding = "nothing is recorded; look at the picture, then `pytest --fumon-update`"
            page = self._session.page()
            page.add(self._file.stem, full, finding, image, recorded, expected, ignored)
            pytest.fail(f"{full}: {finding}\nsee {page.file}", pytrace=False)
        return image


def _drawn(subject: Any, step: int | None, heights: bool, look: dict[str, Any]) -> tuple[Image, str]:
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
    is_picture = not heights and getattr(subject, "dtype", None) == np.uint8 and getattr(subject, "ndim", 0) in (2, 3)
    if not (is_picture or isinstance(subject, (Step, str, os.PathLike))):
        return render(subject, **look), ""
    if look:
        hint = "; heights=True takes an array of uint8 for heights" if getattr(subject, "ndim", 0) == 2 else ""
        raise TypeError(f"{next(iter(look))} changes what is drawn; this is drawn already{hint}")
    if isinstance(subject, Step):
        return subject.image(), ""
    if is_picture and (subject.ndim == 2 or subject.shape[2] == 1):  # grey
        return Image(np.stack([np.asarray(subject).reshape(subject.shape[:2])] * 3, axis=-1)), ""
    if is_picture:
        return subject if isinstance(subject, Image) else Image(subject), ""
    return Image.open(subject), ""


def _mask(mask: npt.NDArray[Any] | str | os.PathLike[str] | None) -> npt.NDArray[np.uint8] | None:
    """A mask as a picture, white where it leaves out."""
    import numpy as np

    from . import _core
    if mask is None:
        return None
    if isinstance(mask, (str, os.PathLike)):
        return _core.read_picture(os.fspath(mask))
    flags = np.asarray(mask)
    if flags.ndim != 2:
        raise ValueError(f"ignore_mask has {flags.ndim} dimensions; it has (height, width)")
    white = flags if flags.dtype == bool else flags >= 128
    return np.repeat(np.where(white, np.uint8(255), np.uint8(0))[:, :, None], 3, axis=2)


@contextlib.contextmanager
def _alone_in(folder: Path) -> Iterator[None]:
    """Waits until no other process of this machine is at work in it here."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield
    finally:
        os.close(descriptor)  # which unlocks it


def kept_picture(lock: Path, name: str) -> Path:
    """Where a picture lies that is kept besides its record."""
    return lock.with_suffix("") / f"{name}.png"


def _plain_name(text: str) -> str:
    return re.sub(r"[^A-Za-z0-9_-]+", "-", text).strip("-")


def _good_name(text: str) -> str:
    """At most 100 letters; what is longer ends in a hash of all of it."""
    name = _plain_name(text)
    return name if len(name) <= 100 else f"{name[:91]}-{hashlib.sha256(text.encode()).hexdigest()[:8]}"
