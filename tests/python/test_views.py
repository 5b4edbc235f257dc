"""fumon.view(): its address answers until it is closed, and nothing of it is left."""

import pathlib
import subprocess
import sys
import threading
import urllib.error
import urllib.request

import numpy as np
import pytest

import fumon

SMALL = {"grid_nx": 32, "grid_ny": 24, "run_steps": 20, "image_width": 160, "image_height": 90}


def _get(url):
    with urllib.request.urlopen(url, timeout=20) as answer:
        return answer.status, answer.read().decode(), dict(answer.headers)


def _threads():
    """Of this process, fumon's own among them, which Python does not count."""
    tasks = pathlib.Path("/proc/self/task")
    return len(list(tasks.iterdir())) if tasks.is_dir() else threading.active_count()


def test_a_scene_is_shown_until_it_is_closed():
    before = _threads()
    with fumon.view("terada-barchans", **SMALL) as window:
        status, page, headers = _get(window.url)
        assert status == 200 and "<title>fumon view</title>" in page
        assert "http://localhost:*" in headers["Content-Security-Policy"] and "X-Frame-Options" not in headers
        assert '"nx":32' in _get(window.url + "subject")[1].replace(" ", "")
        url = window.url
        port = url.split(":")[2].split("/")[0]
        assert window.forward.startswith(f"ssh -L {port}:127.0.0.1:{port} ")
    assert window.closed and window.url == "" and window.forward == "" and "closed" in repr(window)
    window.close()
    with pytest.raises(urllib.error.URLError):
        _get(url)
    assert _threads() == before


def test_a_run_is_shown_by_its_scene():
    run = fumon.Scene("terada-barchans", **SMALL).run(every=10)
    next(run)
    with fumon.view(run) as window:
        assert '"nx":32' in _get(window.url + "subject")[1].replace(" ", "")
    run.scene["grid.nx"] = 8
    assert run.scene["grid.nx"] == 32


def test_results_of_another_model_are_shown(tmp_path):
    xr = pytest.importorskip("xarray")
    level = np.ones((3, 4, 5)) * np.array([2.0, 3.0, 4.0])[:, None, None]
    beds = xr.Dataset({"zb": (("y", "x"), np.zeros((4, 5)), {"units": "m"}), "zs": (("time", "y", "x"), level, {"units": "m"})},
                      {"x": 10.0 * np.arange(5), "y": 10.0 * np.arange(4), "time": ("time", [0, 60, 120], {"units": "s"})})
    beds.to_netcdf(tmp_path / "flood.nc")
    with fumon.view(tmp_path / "flood.nc", image_width=64, image_height=48) as window:
        assert _get(window.url + "subject")[1].count('"step"') >= 3


def test_nothing_answers_without_the_token():
    with fumon.view(np.zeros((8, 9)), cell_size=2) as window:
        with pytest.raises(urllib.error.HTTPError, match="403"):
            _get(window.url.rsplit("/", 2)[0] + "/")


def test_heights_are_shown_with_their_look():
    heights = np.add.outer(np.arange(20.0), np.arange(30.0))
    heights[3, 4] = np.nan
    with fumon.view(heights, cell_size=5, look_palette="batlow", image_width=64, image_height=48) as window:
        subject = _get(window.url + "subject")[1]
        assert '"nx":30' in subject.replace(" ", "") and "batlow" in subject
        shown = window._repr_html_()
        assert f'<iframe src="{window.url}"' in shown and "data:image/png;base64," in shown and "ssh -L " in shown
    assert "iframe" not in window._repr_html_()


def test_a_scene_of_python_and_a_stored_run(tmp_path):
    scene = fumon.Scene("terada-ripples", title="a <b> & c", **SMALL)
    with fumon.view(scene, look_palette="batlow") as window:
        assert scene["look.palette"] != "batlow"
        assert "a &lt;b&gt; &amp; c" in window._repr_html_() and "<b>" not in window._repr_html_()
    with pytest.raises(fumon.InputError, match="palette"):
        fumon.view(scene, look_palette="none")
    with pytest.raises(fumon.InputError):
        fumon.view(tmp_path / "nothing")
    with pytest.raises(ValueError, match="port"):
        fumon.view(scene, port=65536)


def test_a_kernel_that_ends_leaves_nothing():
    code = ("import fumon, sys\nwindow = fumon.view('terada-barchans', grid_nx=32, grid_ny=24, run_steps=20)\n"
            "print(window.url, flush=True)")
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
    url = ended.stdout.strip()
    assert url.startswith("http://127.0.0.1:")
    with pytest.raises(urllib.error.URLError):
        _get(url)
