"""fumon: sand and water landforms, simulated and rendered without a display.

    scene = fumon.Scene("terada-barchans", seed=2, **{"model.creep_rate": 0.3})
    for step in scene.run(every=100):
        step.bed, step.time, step.measures["dune_count"], step.image()

    fumon.render(heights, cell_size=30)         # a picture of any terrain
    fumon.measure(heights, cell_size=30)        # its wavelengths, slopes, dunes …
    fumon.raster(heights, "slope", cell_size=30)  # also aspect, hillshade, drainage, wetness
    fumon.movie(beds, "growth.mp4", cell_size=30)
    fumon.open("flood.nc").film("flood.mp4")    # results of other models; their records, too: fumon.open("flood.nc")[-1].image()
    fumon.film("erosion.mp4")                   # a film of a running model
    fumon.view(scene)                           # in a browser, to be turned, lit and played
    fumon.Bmi()                                 # a model for others to step and change
    fumon.figure_axes(ax, scene)                # a view or map in axes of Matplotlib; also fumon.colormap("batlow")
    fumon.compare(image, other), fumon.fingerprint(image)

Grids are arrays (ny, nx): rows run north, columns east. Row 0 is the southernmost. Heights of terrain are metres.
"""

from pathlib import Path as _Path

from . import _core
from ._core import Error, InputError

__version__: str = _core.version


def _find_data() -> None:
    """Shaders, palettes and scenes lie in the package, or under the prefix where both are installed; else fumon
    finds those of its source folder."""
    here = _Path(__file__).parent
    for folder in (here / "share", *(parent / "share" / "fumon" for parent in here.parents)):
        if (folder / "shaders").is_dir():
            _core.add_data_folder(str(folder))
            return


_find_data()

from .axes import FigureAxes, colormap, figure_axes  # noqa: E402
from .bmi import Bmi  # noqa: E402
from .datasets import GrowingFilm, film  # noqa: E402
from .images import Comparison, Image, compare, fingerprint  # noqa: E402
from .layers import Layers  # noqa: E402
from .measures import Measures  # noqa: E402
from .movies import Movie, movie  # noqa: E402
from .rasters import raster  # noqa: E402
from .results import Record, Results, open  # noqa: E402
from .scene import Run, Scene, Step  # noqa: E402
from .terrain import measure, render, render_layers  # noqa: E402
from .views import View, view  # noqa: E402

try:
    from . import accessor as _accessor  # noqa: F401,E402
except ImportError:  # without xarray there is nothing to be added to
    pass


def pin_rendering() -> None:
    """Draw the same pixels on every x86-64 processor with SSE4.1 (of 2008 or later), as ``fumon --pinned`` does: a fifth slower. Call it before
    anything is drawn; raises Error after that."""
    _core.pin_rendering()


__all__ = [
    "Bmi", "Comparison", "Error", "FigureAxes", "GrowingFilm", "Image", "InputError", "Layers", "Measures", "Movie", "Record", "Results",
    "Run", "Scene", "Step", "View", "colormap", "compare", "figure_axes", "film", "fingerprint", "measure", "movie", "open",
    "pin_rendering", "raster", "render", "render_layers", "view",
]
