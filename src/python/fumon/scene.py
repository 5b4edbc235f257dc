"""Scenes, their runs, and what a run shows between two steps."""

from __future__ import annotations

import copy
import os
import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Iterable, Iterator, NoReturn, SupportsIndex, Union

from . import _core
from .arrays import Bytes, Heights, Numbers
from .images import Image, PathLike, picture_name
from .layers import Layers
from .measures import Measures
from .progress import Progress
from .settings import Setting, key_of, settings_of
from .terrain import CellSize, held_bed

if TYPE_CHECKING:
    import xarray

    from .sweeps import Keys, Over

# Keys in a dict (``**{"model.creep_rate": 0.3}``) are to type checkers what any keyword may take.
_CellSize = Union[CellSize, Setting]
_Word = Setting


class Scene(Mapping[str, Any]):
    """What to simulate and how to show it: a mapping of every key ("model.creep_rate") to its value.

    ``Scene("dunes.toml")`` reads a file, ``Scene("terada-barchans")`` a scene that fumon ships. Keywords set keys,
    with an underscore for the dot (``run_steps=100``) or by their own names (``**{"model.creep_rate": 0.3}``), and so
    does ``scene["model.creep_rate"] = 0.3``. Values are checked at once: InputError says what would be right, with
    file:line:column where the text is wrong.

    bed: heights that the run starts from, in place of the scene's own bed, as fumon.render() takes them: an array
    (ny, nx), metres, whose NaN and masked cells lie outside the terrain; an xarray.DataArray, which brings its cells,
    its place and its reference system; a raster grid of Landlab, of which ``field`` names the heights. ``cell_size`` and
    ``origin`` are those of fumon.render(); without a cell size, grid.cell_size of the scene holds. The heights are
    copied. The scene names them by their SHA-256 (``scene["bed.file"]``), and so does what it saves.
    """

    _bed: _core.HeldBed | None = None

    def __init__(self, source: PathLike, *, bed: Heights | Mapping[str, Setting] | None = None,
                 cell_size: _CellSize = None, origin: _Word = "lower", field: _Word | None = None,
                 **settings: Setting) -> None:
        given = self._with_bed(settings, bed, cell_size, origin, field)
        self._value = _core.SceneValue.read(os.fspath(source), given)

    @classmethod
    def from_toml(cls, text: str, *, bed: Heights | Mapping[str, Setting] | None = None, cell_size: _CellSize = None,
                  origin: _Word = "lower", field: _Word | None = None, **settings: Setting) -> Scene:
        """The scene of a text; files that it names are looked for from the working folder. The others as for Scene()."""
        scene = cls.__new__(cls)
        given = scene._with_bed(settings, bed, cell_size, origin, field)
        scene._value = _core.SceneValue.parse(text, "text", os.getcwd(), given)
        return scene

    def _with_bed(self, settings: Mapping[str, Setting], bed: Any, cell_size: Any, origin: Any,
                  field: Any) -> list[tuple[str, str]]:
        """Settings with a bed, which this scene holds from now on."""
        if bed is None or (isinstance(bed, Mapping) and not hasattr(bed, "data_vars")):
            if cell_size is not None or origin != "lower" or field is not None:
                raise ValueError("cell_size, origin and field are those of bed=, an array")
            return settings_of(settings if bed is None else {"bed": bed, **settings})
        if isinstance(bed, (str, os.PathLike)):
            raise TypeError(f"bed is an array of heights; bed_file={os.fspath(bed)!r} names a file")
        held = held_bed(bed, cell_size, origin, field)
        self._bed = held
        return settings_of({**settings, "bed.kind": "file", "bed.file": held.name})

    def __getitem__(self, key: str) -> Any:
        return self._value.get(key_of(key))

    def __setitem__(self, key: str, value: Setting) -> None:
        if key == "bed" and not isinstance(value, Mapping):
            raise TypeError("an array is the bed of a scene when it is made: fumon.Scene(..., bed=array)")
        self._value.set(settings_of({key: value}))

    def update(self, settings: Mapping[str, Setting] | None = None, **more: Setting) -> None:
        """Sets several keys at once: all of them or, where one is wrong, none."""
        self._value.set(settings_of({**(settings or {}), **more}))

    def __iter__(self) -> Iterator[str]:
        return iter(self._value.keys())

    def __len__(self) -> int:
        return len(self._value.keys())

    def __contains__(self, key: object) -> bool:
        return isinstance(key, str) and key_of(key) in self._value.keys()

    __hash__ = None  # type: ignore[assignment]

    def copy(self) -> Scene:
        """Another scene with the same values. copy.copy and copy.deepcopy give the same: nothing is shared."""
        return copy.copy(self)

    def __copy__(self) -> Scene:
        scene = type(self).__new__(type(self))
        scene.__dict__.update(self.__dict__, _value=self._value.copy())
        return scene

    def __deepcopy__(self, memo: dict[int, Any]) -> Scene:
        scene = type(self).__new__(type(self))
        memo[id(self)] = scene
        own = {name: value for name, value in self.__dict__.items() if name != "_value"}
        scene.__dict__.update(copy.deepcopy(own, memo), _value=self._value.copy())
        return scene

    def __getstate__(self) -> dict[str, Any]:
        """For pickle: its text and what was set, with the folder from which files that it names are looked for."""
        text, source, directory, settings = self._value.parts()
        return {**self.__dict__, "_value": (text, source, os.path.abspath(directory), settings)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, _value=_core.SceneValue.parse(*state["_value"]))

    def to_toml(self) -> str:
        """The scene as TOML, every key with its value."""
        return self._value.toml()

    def __repr__(self) -> str:
        return f"<fumon.Scene {self._value.source}: {self['model.name']}, {self['run.steps']} steps, seed {self['seed']}>"

    def run(self, every: int | None = None, *, at: Iterable[int] | None = None, measures: bool = True,
            threads: int = 0, progress: bool | None = None) -> Run:
        """Runs it from the start: an iterator over Steps.

        every: a Step at 0, every, 2·every … run.steps at most; at: at these steps; neither: with each frame of the
        scene. measures: whether the steps are measured. threads: 0 takes as many as there are processors; the
        results are the same for any number. progress: None shows it on a terminal and in a notebook.
        """
        return Run(self, every, at, measures, threads, progress)

    def at(self, step: int | None = None, *, threads: int = 0, progress: bool | None = None) -> Step:
        """Runs it to a step, by default the run's last one. Its picture is that of ``fumon still``: ``camera.at`` and
        ``camera.look_at`` count from the ground of that step, where those of run() count from that of the first."""
        wanted = self["run.steps"] if step is None else step
        return Run(self, None, [wanted], True, threads, progress).present_as_still()

    def sweep(self, over: Over[Keys] | None = None,
              seeds: int | range | None = None, *, folder: PathLike | None = None, threads: int = 0,
              progress: bool | None = None) -> xarray.Dataset:
        """Runs every combination of values with every seed, on all processors, and gathers what they measured.

        over: {"model.creep_rate": [0.1, 0.2]}; several keys that go together are a tuple. seeds: how many, from the
        scene's own on, or a range. None: as the scene's [sweep] says. folder: where the runs' files stay, and where
        a sweep that was stopped goes on; None: nowhere.

        Returns a Dataset over the parameters as they are called in ``over``, "seed" and "step", with the columns of
        measurements.csv, their units and definitions. A run that fails leaves NaN and a warning.
        """
        from .sweeps import sweep
        return sweep(self._value, over, seeds, folder, threads, progress)


class Run:
    """A run under way: an iterator over its Steps. Any thread may ask it for the next one."""

    def __init__(self, scene: Scene, every: int | None, at: Iterable[int] | None, measures: bool, threads: int,
                 progress: bool | None) -> None:
        if every is not None and at is not None:
            raise ValueError("every and at are two ways to say which steps; give one")
        if every is not None and every < 1:
            raise ValueError(f"every is a number of steps, at least 1, not {every}")
        if threads < 0:
            raise ValueError(f"threads is a number, or 0 for one per processor, not {threads}")
        last = scene["run.steps"]
        self._scene = scene.copy()
        self._steps = _due(scene._value, last, every, at)
        self._due: int | None = None  # what is being stepped to; an interrupt leaves it
        self._live = _core.LiveRun(scene._value, threads, measures)
        self._last = last
        self._progress = Progress(last, "steps", progress)
        if self._live.note:
            warnings.warn(self._live.note, stacklevel=3)

    def __iter__(self) -> Run:
        return self

    @property
    def scene(self) -> Scene:
        """A copy of the scene that runs."""
        return self._scene.copy()

    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn:
        raise TypeError("a Run belongs to its process; copy, pickle or send its Scene and run that")

    def __next__(self) -> Step:
        self._advance()
        return Step(self._live.present())

    def present_as_still(self) -> Step:
        """Steps to the next of its steps, which is drawn as ``fumon still`` draws it."""
        self._advance()
        return Step(self._live.present_as_still())

    def _advance(self) -> None:
        if self._due is None:
            self._due = next(self._steps, None)
        if self._due is None:
            self._progress.close()
            raise StopIteration
        step = self._due
        try:
            self._live.advance(step)
        except BaseException:
            self._progress.close()
            raise
        self._due = None
        self._progress.tell(step)

    @property
    def steps_done(self) -> int:
        """Steps taken so far."""
        return self._live.steps_done

    @property
    def state_hash(self) -> str:
        """SHA-256 of the model's state, as run.json has it."""
        return self._live.state_hash()


def _due(scene: _core.SceneValue, last: int, every: int | None, at: Iterable[int] | None) -> Iterator[int]:
    if every is not None:
        return iter(range(0, last + 1, every))
    if at is not None:
        steps = sorted({int(step) for step in at})
        if steps and (steps[0] < 0 or steps[-1] > last):
            wrong = steps[0] if steps[0] < 0 else steps[-1]
            raise ValueError(f"step {wrong} is not in the run, which has {last} steps; set run.steps")
        return iter(steps)
    return _frames(scene)


def _frames(scene: _core.SceneValue) -> Iterator[int]:
    step = scene.next_frame(-1)
    while step >= 0:
        yield step
        step = scene.next_frame(step)


class Step:
    """A run between two steps. It stays as it is when the run goes on. A notebook shows its picture."""

    def __init__(self, core: _core.Step) -> None:
        self._core = core

    def __reduce_ex__(self, protocol: SupportsIndex) -> NoReturn:
        raise TypeError("a Step belongs to its run; copy, pickle or send its bed, measures or image")

    @property
    def step(self) -> int:
        """How many steps were taken."""
        return self._core.step

    @property
    def time(self) -> float:
        """In ``time_unit``."""
        return self._core.time

    @property
    def time_unit(self) -> str:
        """"s", "yr", or what the model counts ("step")."""
        return self._core.time_unit

    @property
    def bed(self) -> Numbers:
        """Heights (ny, nx), float64, row 0 southernmost; model heights, see ``height_unit``. A view that cannot be
        written to and keeps what it shows; ``.copy()`` gives one of your own."""
        return self._core.bed

    @property
    def fields(self) -> dict[str, Numbers]:
        """What else the model shows ("water_depth"), by name: views as ``bed``."""
        return self._core.fields

    @property
    def field_notes(self) -> dict[str, tuple[str, str]]:
        """(unit, what it is) of each field."""
        return self._core.field_notes

    @property
    def numbers(self) -> dict[str, float]:
        """Numbers that the model keeps besides its fields."""
        return self._core.numbers

    @property
    def nodata(self) -> Bytes | None:
        """1 in cells outside the domain, (ny, nx); None where there are none."""
        return self._core.nodata

    @property
    def cell_size(self) -> tuple[float, float] | None:
        """(dx, dy), metres; None for a model in sites."""
        return self._core.cell_size

    @property
    def height_unit(self) -> float | None:
        """Metres of a model height; None for a model in sites."""
        return self._core.height_unit

    @property
    def measures(self) -> Measures:
        """The row of measurements.csv, by name. Celerities count from the Step before."""
        measured = self._core.measured
        if not measured:
            raise ValueError("this run measures nothing; run it with measures=True")
        return Measures(measured)

    def image(self) -> Image:
        """The picture of ``fumon still`` at this step, to the byte."""
        return Image.drawn(self._core.drawn())

    def layers(self) -> Layers:
        """The light of that picture before exposure and tone curve, without overlays, and what each pixel shows: depth,
        normals, positions and the bed's fields. ``output_exr_layers="colour"`` in the scene leaves it at the light.
        InputError for the flat figure of a section, which has none."""
        return Layers.drawn(self._core.layers())

    def save(self, file: PathLike) -> None:
        """Writes that picture as PNG, JPEG (.jpg, .jpeg) or WebP or, where the name ends in .exr, its layers as OpenEXR,
        with all that ``fumon again`` needs to make it once more. ``image_quality`` and ``image_lossless`` of the scene are
        those of JPEG and WebP."""
        if os.fspath(file).lower().endswith(".exr"):
            _core.write_file(os.fspath(file), self._core.exr())
        else:
            name = picture_name(file)
            _core.write_file(name, self._core.still(name))

    def _repr_png_(self) -> bytes:
        return self._core.still(".png")

    def __repr__(self) -> str:
        ny, nx = self.bed.shape
        return f"<fumon.Step {self.step}: {nx} x {ny} cells>"
