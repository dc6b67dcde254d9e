"""Golden summaries on disk: a flight is held against its file, or writes it anew when that is asked for."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

FOLDER = Path(__file__).parent / "golden"
REFRESH = os.environ.get("BUMPLESS_REFRESH_GOLDEN") == "1"


def hold_against(name: str, got: dict[str, Any]) -> dict[str, Any]:
    """Compare end and mean commands of a summary with golden/NAME.json; returns what the file says."""
    path = FOLDER / f"{name}.json"
    if REFRESH:
        path.write_text(json.dumps(got, indent=1) + "\n", encoding="utf-8")
    wanted = json.loads(path.read_text(encoding="utf-8"))
    assert got["end"]["cycles"] == wanted["end"]["cycles"]
    for part in ("eta", "nu"):
        assert got["end"][part] == pytest.approx(wanted["end"][part], rel=5e-3, abs=2e-4), part
    assert got["commands"] == pytest.approx(wanted["commands"], rel=5e-3, abs=1e-4)
    return wanted
