"""Saved views of the list: on the disk, in bounds, and no broken file ends anything."""

from pathlib import Path

import pytest

from bumpless_server.runs.run_views import MOST, RunView, RunViews, TooMany


def views(folder: Path) -> RunViews:
    return RunViews(folder / "run_views.json")


def test_views_survive_a_restart_and_a_broken_file_is_no_end(tmp_path: Path) -> None:
    """Protects what people keep; what is no view is left out, and the rest stays."""
    view = RunView("calm", "docked", ("seed",), "Ada")
    assert views(tmp_path).keep("Calm", view) is None
    assert views(tmp_path).all() == {"Calm": view}
    assert views(tmp_path).keep("Calm", RunView()) == view
    text = (tmp_path / "run_views.json").read_text()
    (tmp_path / "run_views.json").write_text(text[:-1] + ', "odd": 3, "half": {"words": ""}}')
    assert views(tmp_path).all() == {"Calm": RunView()}
    for broken in ("{", "[]", "3"):
        (tmp_path / "run_views.json").write_text(broken)
        assert views(tmp_path).all() == {}


def test_they_are_bounded(tmp_path: Path) -> None:
    """Protects the disk and the menu from a script that never ends."""
    kept = views(tmp_path)
    for number in range(MOST):
        kept.keep(str(number), RunView())
    with pytest.raises(TooMany):
        kept.keep("one more", RunView())
    kept.keep("0", RunView("changed"))
    assert kept.forget("0") == RunView("changed") and kept.forget("0") is None
    kept.keep("one more", RunView())
