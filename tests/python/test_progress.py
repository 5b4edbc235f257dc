"""Progress on a terminal and in a notebook, here with stand-ins of both."""

import sys
import types

from fumon import progress


def at_once(monkeypatch):
    monkeypatch.setattr(progress, "_between_looks", 0.0)


def test_a_terminal_shows_one_line_and_is_left_clean(monkeypatch, capsys, barchans):
    at_once(monkeypatch)
    for _ in barchans.run(every=20, progress=True):
        pass
    told = capsys.readouterr().err
    assert "20 of 40 steps" in told and told.endswith("\r\033[K")
    for _ in barchans.run(every=20):
        pass
    assert capsys.readouterr().err == ""  # no terminal


def test_a_notebook_updates_one_display(monkeypatch, capsys, barchans):
    at_once(monkeypatch)
    pages = []

    class Handle:
        def update(self, page):
            pages.append(page)

    def display(page, display_id):
        assert display_id is True and not pages
        pages.append(page)
        return Handle()

    shown = types.SimpleNamespace(HTML=str, display=display)
    shell = types.SimpleNamespace(kernel=object())
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(get_ipython=lambda: shell, display=shown))
    monkeypatch.setitem(sys.modules, "IPython.display", shown)
    for _ in barchans.run(every=20):
        pass
    assert any("value='20' max='40'" in page for page in pages) and pages[-1] == ""
    pages.clear()
    barchans.sweep(seeds=2)
    assert capsys.readouterr().err == ""
