#!/usr/bin/env python3
"""Twenty changing frames by fumon and by VTK, whole processes: CPU seconds (user and system), memory, and their ratios.

    tests/bench/peers/frames.py build/release/fumon
    tests/bench/peers/frames.py build/release/fumon --cells 512 --vtk=--samples=window --vtk=--shadows

"rippled" moves dunes that carry ripples, "rough" roughens them at the scale of the cells, as young beds are; VTK draws
the former (its cost does not depend on it). Programs take turns, and the least of their times counts, since others
on the machine only add to it. Needs what vtk_frames.py needs, and Xvfb (Debian package xvfb).
"""

import argparse
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
DISPLAY = ":97"


def measured(command):
    """CPU seconds and megabytes of a process."""
    process = subprocess.Popen([str(part) for part in command], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{command[0]} failed")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000


@contextlib.contextmanager
def virtual_display():
    """A display by Xvfb, which VTK needs for an off-screen window."""
    display = subprocess.Popen(["Xvfb", DISPLAY, "-screen", "0", "640x480x24"], stderr=subprocess.DEVNULL)
    os.environ["DISPLAY"] = DISPLAY
    time.sleep(2)
    try:
        yield
    finally:
        display.terminate()
        display.wait()


def in_turns(commands, turns):
    """The least CPU seconds of each command, and the memory of that process."""
    least = {}
    for _ in range(turns):
        for name, command in commands.items():
            least[name] = min(least.get(name, (float("inf"), 0)), measured(command))
    return least


def fumon_command(fumon, scene, cells, work):
    heights = f"bed.heights=[{-0.005 * cells},{0.045 * cells}]"  # black and white of the bed's picture
    return [fumon, "run", HERE / f"frames-{scene}.toml", "--quiet", "--force", "-o", work / "frames",
            "--set", f"bed.file={work / 'bed.png'}", "--set", heights]


def compare(fumon, cells, turns, vtk_options, work):
    vtk = [sys.executable, HERE / "vtk_frames.py", cells]
    measured([*vtk, work / "bed.png", "--write-bed"])
    commands = {scene: fumon_command(fumon, scene, cells, work) for scene in ("rippled", "rough")}
    commands["VTK"] = [*vtk, work / "vtk", *vtk_options]
    least = in_turns(commands, turns)
    for name, (seconds, megabytes) in least.items():
        ratio = "" if name == "VTK" else f"  {seconds / least['VTK'][0]:.2f} of VTK's"
        print(f"{cells:5}²  {name:8}  {seconds:6.2f} s  {megabytes:5.0f} MB{ratio}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fumon", type=pathlib.Path)
    parser.add_argument("--cells", type=int, action="append", help="along each side of the bed (512 and 1024)")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--vtk", action="append", default=[], help="an option of vtk_frames.py")
    arguments = parser.parse_args()
    with virtual_display(), tempfile.TemporaryDirectory() as work:
        for cells in arguments.cells or [512, 1024]:
            compare(arguments.fumon.resolve(), cells, arguments.turns, arguments.vtk, pathlib.Path(work))


if __name__ == "__main__":
    main()
