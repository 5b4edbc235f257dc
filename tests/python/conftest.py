"""What the tests of the Python module share."""

import os
import subprocess
import sys

import pytest

import fumon

SMALL = {"run_steps": 40, "grid_nx": 48, "grid_ny": 32, "image_width": 192, "image_height": 108}


@pytest.fixture
def barchans():
    """A sand scene of 48 x 32 sites and 40 steps, whose pictures are small."""
    return fumon.Scene("terada-barchans", **SMALL)


@pytest.fixture
def in_another():
    """Runs Python code in another process; its standard output."""

    def run(code, env=None, check=True):
        done = subprocess.run([sys.executable, "-c", code], env={**os.environ, **(env or {})}, text=True,
                              capture_output=True, timeout=120)
        if check:
            assert done.returncode == 0, done.stderr
        return done.stdout

    return run
