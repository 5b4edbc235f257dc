"""The notebooks of the guide, run from the first cell to the last. A test of CTest of their own, python.Notebooks, since a kernel and
Matplotlib take their time."""

import os
import pathlib
import shutil

import pytest

nbformat = pytest.importorskip("nbformat", reason="python3-nbformat is not installed")
preprocessors = pytest.importorskip("nbconvert.preprocessors", reason="python3-nbconvert is not installed")
pytest.importorskip("ipykernel", reason="python3-ipykernel is not installed")
pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")

GUIDE = pathlib.Path(os.environ["FUMON_GUIDE"])


def executed(name, folder):
    """The notebook with what its cells gave; the terrain lies beside it as beside the guide."""
    (folder / "guide" / "notebooks").mkdir(parents=True)
    shutil.copytree(GUIDE.parent / "terrain", folder / "terrain")
    book = nbformat.read(GUIDE / "notebooks" / name, as_version=4)
    place = {"metadata": {"path": str(folder / "guide" / "notebooks")}}
    preprocessors.ExecutePreprocessor(timeout=300, kernel_name="python3").preprocess(book, place)
    outputs = [output for cell in book.cells if cell.cell_type == "code" for output in cell.outputs]
    assert not [output for output in outputs if output.output_type == "error"]
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    words = "".join(output.get("text", "") for output in outputs if output.output_type == "stream")
    return len(pictures), words, folder / "guide" / "notebooks"


def test_a_phase_diagram(tmp_path):
    pictures, words, folder = executed("phase-diagram.ipynb", tmp_path)
    assert pictures == 1 and (folder / "phase-diagram.png").stat().st_size > 50_000
    assert "{'nothing grows': " in words
    counts = [int(part.split(":")[1].strip(" }\n")) for part in words[words.index("{'nothing"):].split(",")[:3]]
    assert sum(counts) == 42 and min(counts) >= 3  # every phase is there


def test_a_figure_for_a_journal(tmp_path):
    font_manager = pytest.importorskip("matplotlib.font_manager")
    if "IPAexGothic" not in {font.name for font in font_manager.fontManager.ttflist}:
        pytest.skip("fonts-ipaexfont-gothic is not installed")
    pictures, words, folder = executed("journal-figure.ipynb", tmp_path)
    assert pictures == 3  # the map, and the figure in both languages
    assert "129 m × 267 m" in words
    assert sorted(file.name for file in folder.iterdir()) == ["gully-en.pdf", "gully-en.png", "gully-ja.pdf", "gully-ja.png"]


def test_they_are_kept_without_outputs():
    for file in (GUIDE / "notebooks").glob("*.ipynb"):
        for cell in nbformat.read(file, as_version=4).cells:
            assert cell.cell_type != "code" or (not cell.outputs and cell.execution_count is None), file
