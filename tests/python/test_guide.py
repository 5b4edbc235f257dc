"""The blocks of the guide's page on Python, in their order."""

import os
import pathlib
import re

GUIDE = pathlib.Path(os.environ["FUMON_GUIDE"]) / "python.md"


def test_the_guides_blocks_run(tmp_path, monkeypatch, capsys):
    blocks = re.findall(r"^```python\n(.*?)^```", GUIDE.read_text(), re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 6
    monkeypatch.chdir(tmp_path)
    names = {}
    for block in blocks:
        exec(compile(block, str(GUIDE), "exec"), names)
    told = capsys.readouterr().out
    for promised in re.findall(r"print\(.*\) +# (.*)", "\n".join(blocks)):
        assert promised in told
    assert {file.name for file in tmp_path.iterdir()} == {"hill.png", "last.png", "barchans.mp4", "growth.webp"}
