"""The table of Japanese words has the columns that models are measured by."""

import os
import pathlib
import re

import pytest

import fumon

TABLE = (pathlib.Path(os.environ["FUMON_GUIDE"]).parent / "words" / "ja.toml").read_text(encoding="utf-8")
NAMES = set(re.findall(r'^"([^"]+)" = "[^"]+"$', TABLE.partition("[names]")[2], re.MULTILINE))

MODELS = {
    "sand": "", "dunes": "", "sandpile": "", "gully": "", "static": "", "water": "", "airflow": "ny = 1",
}


@pytest.mark.parametrize("model", MODELS)
def test_every_measured_column_has_japanese_words(model):
    scene = fumon.Scene.from_toml(f'[model]\nname = "{model}"\n[grid]\nnx = 32\n{MODELS[model] or "ny = 32"}\n[run]\nsteps = 1\n')
    lacking = [name for name in scene.at(1, progress=False).measures if name.replace("_", " ") not in NAMES]
    assert not lacking
