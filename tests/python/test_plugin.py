"""The pytest plugin: records, compares, shows what differs."""

import importlib.metadata
import os
import pathlib
import re
import subprocess
import sys
import time

import pytest

pytest_plugins = "pytester"

# An installed fumon makes itself known to pytest.
INSTALLED = any(entry.value == "fumon.pytest_plugin" for entry in importlib.metadata.entry_points(group="pytest11"))
WORDS = ("-q", "-p", "no:cacheprovider", *(() if INSTALLED else ("-p", "fumon.pytest_plugin")))

TEST = """
import numpy as np
import pytest
import fumon

y, x = np.mgrid[0:14, 0:20]
HILLS = 3.0 * np.sin(0.5 * x) + 2.0 * np.cos(0.4 * y)
SMALL = dict(image_width=96, image_height=64)

@pytest.mark.parametrize("azimuth", [0, 90])
def test_hills(fumon_image, azimuth):
    image = fumon_image(HILLS, cell_size=2, camera_azimuth=azimuth + TURN, picture=True, **SMALL)
    assert isinstance(image, fumon.Image)

def test_run(fumon_image):
    scene = fumon.Scene("terada-barchans", grid_nx=24, grid_ny=16, run_steps=9, seed=SEED, **SMALL)
    fumon_image(scene, step=5)
    fumon_image(scene.at(5), name="as-step")
    fumon_image(np.asarray(scene.at(5).image()), name="as-array", thumbnail_difference=200)
"""


@pytest.fixture
def run(pytester):
    def run_tests(*words, turn=0, seed=1, text=TEST):
        pytester.makepyfile(test_it=text.replace("TURN", str(turn)).replace("SEED", str(seed)))
        return pytester.runpytest(*WORDS, *words)

    return run_tests


def test_records_and_compares(pytester, run):
    first = run()
    first.assert_outcomes(failed=3)
    first.stdout.fnmatch_lines(["*nothing is recorded*--fumon-update*", "*see *fumon-images/index.html"])
    assert not (pytester.path / "pictures.lock").exists()

    update = run("--fumon-update")
    update.assert_outcomes(passed=3)
    update.stdout.fnmatch_lines(["fumon: *test_it-test_hills-0: recorded; look at it*"])
    lock = (pytester.path / "pictures.lock").read_text()
    assert lock.count("[recorded.") == 5
    kept = sorted(file.name for file in (pytester.path / "pictures").iterdir())
    assert kept == ["test_it-test_hills-0.png", "test_it-test_hills-90.png"]
    assert (pytester.path / "fumon-images" / "index.html").exists() is False  # the page of the first run is gone

    run().assert_outcomes(passed=3)
    again = run("--fumon-update")
    assert "recorded" not in again.stdout.str() and (pytester.path / "pictures.lock").read_text() == lock

    turned = run("-k", "hills", turn=5)
    turned.assert_outcomes(failed=2, deselected=1)
    turned.stdout.fnmatch_lines(["*thumbnail * of 0.5*tile SSIM*"])
    page = (pytester.path / "fumon-images" / "index.html").read_text()
    assert page.count("<section") == 2 and "difference" in page

    other = run("-k", "run", seed=2)
    other.assert_outcomes(failed=1, deselected=2)
    other.stdout.fnmatch_lines(["*the state differs*"])

    changed = run("--fumon-update", "-k", "hills", turn=5)
    changed.stdout.fnmatch_lines(["fumon: *test_it-test_hills-0: *"])
    assert (pytester.path / "pictures.lock").read_text().count("[recorded.") == 5  # those not run are kept
    run("-k", "hills", turn=5).assert_outcomes(passed=2, deselected=1)

    (pytester.path / "pictures" / "test_it-test_hills-0.png").unlink()
    run("-k", "hills", turn=5).assert_outcomes(passed=1, failed=1, deselected=1)


def test_the_guides_page_on_image_tests(pytester, run):
    page = (pathlib.Path(os.environ["FUMON_GUIDE"]) / "image-tests.md").read_text()
    (text,) = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    run("--fumon-update", text=text).assert_outcomes(passed=2)
    run(text=text).assert_outcomes(passed=2)
    assert [file.name for file in (pytester.path / "pictures").iterdir()] == ["test_it-test_picture.png"]
    run(text=text.replace("200 - x", "199 - x").replace("[1] / 4", "[1] / 3")).assert_outcomes(failed=2)


def test_wrong_uses(pytester, run):
    twice = run(text="def test_it(fumon_image):\n    import numpy as np\n    a = np.zeros((4, 4, 3), np.uint8)\n"
                     "    try:\n        fumon_image(a)\n    except BaseException: pass\n    fumon_image(a)")
    twice.stdout.fnmatch_lines(["*give this one a name=*"])
    for call, words in (("fumon_image(np.zeros((4, 4)), step=3)", "step is of a scene"),
                        ("fumon_image(np.zeros((4, 4, 3), np.uint8), look_tone='agx')", "drawn already"),
                        ("fumon_image(np.zeros((4, 4)), look_ton='agx')", "did you mean")):
        wrong = run(text=f"def test_it(fumon_image):\n    import numpy as np\n    {call}")
        wrong.assert_outcomes(failed=1)
        assert words in wrong.stdout.str()
    (pytester.path / "pictures.lock").write_text("[recorded.x]\nsize = 3\n")
    damaged = run(text="def test_it(fumon_image):\n    import numpy as np\n    fumon_image(np.zeros((4, 4, 3), np.uint8))")
    damaged.stdout.fnmatch_lines(["*pictures.lock:2:8: *"])
    (pytester.path / "pictures.lock").write_text(
        "# Recorded by `fumon verify --update`, which writes it anew. Commit it.\n")
    other = run(text="def test_it(fumon_image):\n    import numpy as np\n    fumon_image(np.zeros((4, 4, 3), np.uint8))")
    other.stdout.fnmatch_lines(["*pictures.lock:1:1: was recorded by `fumon verify`*"])


def test_pinned_records_pin(pytester):
    pytester.makepyfile(test_it=TEST.replace("TURN", "0").replace("SEED", "1"))
    words = (*WORDS, "-k", "hills")
    pytester.runpytest_subprocess(*words, "--fumon-update", "--fumon-pinned").assert_outcomes(passed=2, deselected=1)
    assert "pinned = true" in (pytester.path / "pictures.lock").read_text()
    pytester.runpytest_subprocess(*words).assert_outcomes(passed=2, deselected=1)


def test_a_grey_picture_is_a_picture(pytester, run):
    text = """
import numpy as np
import fumon

GREY = np.arange(40 * 60, dtype=np.uint8).reshape(40, 60)

def test_grey(fumon_image):
    grey = fumon_image(GREY, picture=True)
    assert grey.shape == (40, 60, 3) and all(np.array_equal(grey[:, :, k], GREY) for k in range(3))
    assert np.array_equal(fumon_image(GREY[:, :, None], name="one-channel"), grey)
    assert np.array_equal(fumon_image(grey[:, :, 1], name="of-a-picture"), grey)

def test_heights(fumon_image):
    drawn = fumon_image(GREY, heights=True, image_width=96, image_height=64)
    assert drawn.shape == (64, 96, 3) and np.array_equal(drawn, fumon.render(GREY, image_width=96, image_height=64))
    fumon_image(GREY.astype(np.int16), name="whole-metres", image_width=96, image_height=64)
"""
    run("--fumon-update", text=text).assert_outcomes(passed=2)
    run(text=text).assert_outcomes(passed=2)
    wrong = run(text="def test_it(fumon_image):\n    import numpy as np\n    fumon_image(np.zeros((4, 4), np.uint8), camera_azimuth=3)")
    wrong.stdout.fnmatch_lines(["*camera_azimuth changes what is drawn; * heights=True takes *"])


CLASSES = """
import numpy as np
import pytest

def flat(level):
    return np.full((8, 9, 3), level, np.uint8)

class TestRed:
    @pytest.mark.parametrize("level", [10, 20])
    def test_one(self, fumon_image, level):
        fumon_image(flat(level), picture=True)

class TestBlue:
    def test_one(self, fumon_image):
        fumon_image(flat(30))

@pytest.mark.parametrize("text", ["long" * 40 + "a", "long" * 40 + "b"])
def test_long(fumon_image, text):
    fumon_image(flat(len(text)), name="x")

def test_plain(fumon_image):
    fumon_image(flat(50))
    fumon_image(flat(60), name="second")
"""


def recorded(pytester):
    return sorted(re.findall(r"^\[recorded\.(.*)\]", (pytester.path / "pictures.lock").read_text(), re.MULTILINE))


def test_names_tell_class_and_parameters(pytester, run):
    run("--fumon-update", text=CLASSES).assert_outcomes(passed=6)
    names = recorded(pytester)
    assert [name for name in names if "long" not in name] == [
        "test_it-TestBlue-test_one", "test_it-TestRed-test_one-10", "test_it-TestRed-test_one-20", "test_it-test_plain",
        "test_it-test_plain-second"]
    long = [name for name in names if "long" in name]
    assert len(long) == 2 and all(len(name) == 100 for name in long)
    # Records of before have no class: they count, and the next update gives them their names.
    lock = pytester.path / "pictures.lock"
    lock.write_text(lock.read_text().replace("TestRed-", "").replace("TestBlue-", ""))
    for file in (pytester.path / "pictures").iterdir():
        file.rename(file.with_name(file.name.replace("TestRed-", "")))
    before = run(text=CLASSES)
    before.assert_outcomes(passed=6)
    assert "no test draws" not in before.stdout.str()
    run("--fumon-update", text=CLASSES)
    assert recorded(pytester) == names
    assert sorted(file.name for file in (pytester.path / "pictures").iterdir()) == [f"{name}.png" for name in names if "TestRed" in name]


def test_records_of_tests_that_are_gone(pytester, run):
    run("--fumon-update", text=CLASSES)
    (pytester.path / "test_other.py").write_text("def test_it(fumon_image):\n    import numpy as np\n"
                                                 "    fumon_image(np.zeros((8, 9, 3), np.uint8))")
    run("--fumon-update", text=CLASSES).assert_outcomes(passed=7)
    names = recorded(pytester)
    less = CLASSES.replace("[10, 20]", "[10]")
    gone = "test_it-TestRed-test_one-20"
    run(text=less).stdout.fnmatch_lines([f"fumon: */{gone}: is recorded, and no test draws it; --fumon-update removes it"])
    skipped = less.replace("def test_plain", "@pytest.mark.skip\ndef test_plain")
    failing = less.replace("    fumon_image(flat(50))", "    assert False")
    for words, text in ((["-k", "plain"], less), (["test_it.py::test_plain"], less), (["test_other.py"], less), ([], skipped),
                        ([], failing), (["-x"], failing)):
        part = run("--fumon-update", *words, text=text)
        assert recorded(pytester) == names and "no test draws" not in part.stdout.str(), words
    run("--fumon-update", text=less).stdout.fnmatch_lines([f"fumon: */{gone}: removed, as no test draws it"])
    assert recorded(pytester) == [name for name in names if name != gone]
    assert [file.name for file in (pytester.path / "pictures").iterdir()] == ["test_it-TestRed-test_one-10.png"]
    (pytester.path / "test_other.py").unlink()
    run("--fumon-update", "-k", "plain", text=less)
    assert recorded(pytester) == [name for name in names if name != gone and "test_other" not in name]


def test_several_processes(pytester, run):
    pytest.importorskip("xdist")
    run("--fumon-update", text=CLASSES)
    names = recorded(pytester)
    pytester.makepyfile(test_it=CLASSES.replace("flat(30)", "flat(90)").replace("flat(50)", "flat(90)"))
    words = (*WORDS, "-n", "2")
    changed = pytester.runpytest_subprocess(*words)
    changed.assert_outcomes(passed=4, failed=2)
    pages = sorted((pytester.path / "fumon-images").glob("gw*/index.html"))
    assert sum(page.read_text().count("<section") for page in pages) == 2
    for page in pages:
        changed.stdout.fnmatch_lines([f"fumon: pictures that differ: {page}"])
    pytester.makepyfile(test_it=CLASSES)
    pytester.runpytest_subprocess(*words).assert_outcomes(passed=6)
    assert list((pytester.path / "fumon-images").glob("**/index.html")) == []


def test_several_processes_record(pytester, run):
    pytest.importorskip("xdist")
    pytester.makepyfile(test_it=CLASSES, test_other=CLASSES)
    words = (*WORDS, "-n", "2")
    first = pytester.runpytest_subprocess(*words, "--fumon-update")
    first.assert_outcomes(passed=12)
    names = recorded(pytester)
    assert len(names) == 14 and first.stdout.str().count("recorded; look at it") == 14
    assert len(list((pytester.path / "pictures").iterdir())) == 4
    lock = (pytester.path / "pictures.lock").read_text()
    run("--fumon-update", text=CLASSES).assert_outcomes(passed=12)
    assert (pytester.path / "pictures.lock").read_text() == lock  # as one process records it
    pytester.runpytest_subprocess(*words).assert_outcomes(passed=12)


def test_processes_that_record_at_once_keep_each_others_records(pytester, run):
    """The second records while the first one, which has read the lock, is still at work."""
    waiting = """
import pathlib
import time

import numpy as np

def test_one(fumon_image):
    fumon_image(np.full((8, 9, 3), 10, np.uint8))
    pathlib.Path("drawn").touch()
    for _ in range(600):
        if pathlib.Path("other").exists():
            return
        time.sleep(0.1)
    assert False
"""
    pytester.makepyfile(test_waiting=waiting)
    other = "import numpy as np\n\ndef test_two(fumon_image):\n    fumon_image(np.full((8, 9, 3), 20, np.uint8))\n"
    pytester.makepyfile(test_other=other)
    words = [sys.executable, "-m", "pytest", *WORDS, "--fumon-update"]
    first = subprocess.Popen([*words, "test_waiting.py"], stdout=subprocess.DEVNULL)
    while not (pytester.path / "drawn").exists():
        assert first.poll() is None
        time.sleep(0.1)
    subprocess.run([*words, "--fumon-output", "second", "test_other.py"], stdout=subprocess.DEVNULL, check=True)
    assert recorded(pytester) == ["test_other-test_two"]
    (pytester.path / "other").touch()
    assert first.wait(60) == 0
    assert recorded(pytester) == ["test_other-test_two", "test_waiting-test_one"]


def test_ignores_boxes_and_masks(pytester, run):
    text = """
import numpy as np

def picture(level):
    image = np.full((40, 60, 3), 100, np.uint8)
    image[4:9, 6:11] = level
    return image

MASK = np.zeros((40, 60), bool)
MASK[4:9, 6:11] = True

def test_box(fumon_image):
    fumon_image(picture(LEVEL), picture=True, ignore=[(6, 4, 5, 5)])

def test_mask(fumon_image):
    fumon_image(picture(LEVEL), exact=True, ignore_mask=MASK)

def test_too_small(fumon_image):
    fumon_image(picture(LEVEL), picture=True, ignore=[(6, 4, 5, 4)])

def test_too_large(fumon_image):
    fumon_image(picture(LEVEL), ignore=[(0, 0, 60, 13)])

def test_other_size(fumon_image):
    fumon_image(picture(LEVEL), ignore_mask=MASK[1:])
"""
    first = run("--fumon-update", text=text.replace("LEVEL", "100"))
    first.assert_outcomes(passed=3, failed=2)
    first.stdout.fnmatch_lines(["*32.5 % of the picture would be ignored*", "*it has 60 x 39 pixels; the picture has 60 x 40*"])
    other = run(text=text.replace("LEVEL", "250"))
    other.assert_outcomes(passed=2, failed=3)
    other.stdout.fnmatch_lines(["*test_too_small: *% of the picture ignored*"])
    without = run("-k", "box", text=text.replace("LEVEL", "100").replace("ignore=[(6, 4, 5, 5)]", "ignore=[(6, 4, 5, 6)]"))
    without.stdout.fnmatch_lines(["*what is ignored is not what it was*"])


def test_exactly(pytester, run):
    text = """
import numpy as np

def picture(level):
    image = np.full((40, 60, 3), 100, np.uint8)
    image[5, 7] = level
    return image

def test_exact(fumon_image):
    fumon_image(picture(LEVEL), exact=True)

def test_to_the_eye(fumon_image):
    fumon_image(picture(LEVEL))
"""
    run("--fumon-update", text=text.replace("LEVEL", "100")).assert_outcomes(passed=2)
    run(text=text.replace("LEVEL", "100")).assert_outcomes(passed=2)
    other = run(text=text.replace("LEVEL", "101"))
    other.assert_outcomes(passed=1, failed=1)
    other.stdout.fnmatch_lines(["*test_exact: exact: portable *its pixels differ*"])
