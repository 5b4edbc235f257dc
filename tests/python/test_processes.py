"""Threads, forks, interrupts, and a machine without OpenGL."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import fumon
from conftest import SMALL

SCENE = f"""
import fumon, os, sys
scene = fumon.Scene("terada-barchans", **{SMALL!r})
"""


def test_two_scenes_in_two_threads(barchans):
    other = barchans.copy()
    other["seed"] = 7
    alone = [scene.at(40).image() for scene in (barchans, other)]
    drawn = [None, None]

    def work(index, scene):
        for step in scene.run(every=20):
            drawn[index] = step.image()

    threads = [threading.Thread(target=work, args=(index, scene)) for index, scene in enumerate((barchans, other))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(got, expected) for got, expected in zip(drawn, alone))


def test_one_run_from_two_threads(barchans):
    run = barchans.run(every=20)
    step = next(run)
    found = []
    thread = threading.Thread(target=lambda: found.extend([step.image(), next(run).step]))
    thread.start()
    picture = step.image()
    thread.join()
    assert np.array_equal(found[0], picture) and found[1] == 20


def test_others_work_while_a_run_steps(barchans):
    barchans.update(run_steps=300, grid_nx=256, grid_ny=256)
    counted = 0
    thread = threading.Thread(target=lambda: barchans.at(300))
    thread.start()
    while thread.is_alive():
        time.sleep(0.001)
        counted += 1
    assert counted > 10


@pytest.mark.parametrize("work", ["run", "sweep"])
def test_ctrl_c_stops_within_a_step(barchans, work):
    barchans.update(run_steps=10**7, grid_nx=128, grid_ny=128)
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    began = time.monotonic()
    run = barchans.run(at=[10**7])
    with pytest.raises(KeyboardInterrupt):
        next(run) if work == "run" else barchans.sweep({"model.creep_rate": [0.1, 0.2, 0.3]})
    assert time.monotonic() - began < 5
    barchans["run.steps"] = 3
    assert barchans.at().step == 3  # and what comes after is not stopped


def test_a_run_goes_on_after_ctrl_c(barchans):
    barchans["run.steps"] = 10**7
    run = barchans.run(at=[10**7])
    stopped_at = [0]
    for _ in range(2):
        threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with pytest.raises(KeyboardInterrupt):
            next(run)
        stopped_at.append(run.steps_done)
    assert 0 < stopped_at[1] < stopped_at[2]
    other = barchans.run(at=stopped_at[-1:])
    next(other)
    assert run.state_hash == other.state_hash


def test_a_fork_of_a_run_is_told_so(in_another):
    told = in_another(SCENE + """
run = scene.run(every=10)
step = next(run)
step.image()
if os.fork() == 0:
    for work in (lambda: next(run), step.image, lambda: scene.at(0).image()):
        try:
            work()
        except fumon.Error as error:
            print(error, flush=True)
    assert step.bed.shape == (32, 48)
    print(next(scene.run(every=10)).bed.sum() == step.bed.sum(), flush=True)  # what is begun here works
    del run, step
    os._exit(0)  # as multiprocessing does; Mesa does not survive exit() in a fork of a process that has drawn
_, status = os.wait()
print("status", status)
""")
    lines = told.splitlines()
    assert [line for line in lines if "forked" in line and "spawn" in line] == lines[:3]
    assert lines[3:] == ["True", "status 0"]


def test_processes_that_are_spawned_draw():
    code = SCENE + """
import multiprocessing
def hash_of(seed):
    scene["seed"] = seed
    return fumon.fingerprint(scene.at(10).image())["pixels_sha256"]
def bed_of(sent):
    return sent.at(10).bed.tobytes()
if __name__ == "__main__":
    here = hash_of(3)
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(hash_of, [3]) == [here]
        assert pool.map(bed_of, [scene]) == [bed_of(scene)]  # sent as it is
"""
    import tempfile
    with tempfile.NamedTemporaryFile("w", suffix=".py") as file:
        file.write(code)
        file.flush()
        subprocess.run([sys.executable, file.name], check=True, timeout=120)


def test_without_opengl_one_exception_says_what_is_missing(in_another, tmp_path):
    for name in ("libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", "libEGL.so.1"):
        (tmp_path / name).write_text("")
    told = in_another(SCENE + """
step = scene.at(10)
for work in (step.image, lambda: fumon.render(step.bed)):
    try:
        work()
    except fumon.Error as error:
        print(type(error).__name__, error)
print(step.bed.shape)
""", {"LD_LIBRARY_PATH": str(tmp_path)})
    lines = told.splitlines()
    assert all(line.startswith("Error no OpenGL 3.3 without a display") and "libosmesa6" in line for line in lines[:2])
    assert lines[2:] == ["(32, 48)"]


def test_pinned_pixels_and_that_it_comes_too_late(in_another):
    told = in_another(SCENE + """
fumon.pin_rendering()
scene.at(0).image()
""" + """
import subprocess
""")
    assert told == ""
    told = in_another(SCENE + """
scene.at(0).image()
try:
    fumon.pin_rendering()
except fumon.Error as error:
    print("late")
""")
    assert told == "late\n"
