"""Tables and MOOS logs of a run: the numbers are the log's, and only those that were asked for."""

import csv
import math
from pathlib import Path

import pyarrow.parquet as parquet
import pytest

from bumpless.runs.cut import Range
from bumpless.runs.export import export
from tests.runs.flights import Flight


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_csv_holds_the_chosen_signals_of_the_range(flight: Flight, tmp_path: Path) -> None:
    """Protects spreadsheets: every digit of the log, one row per cycle of the range."""
    target = tmp_path / "run.csv"
    export(flight.path, target, "csv", Range(10.0, 20.0), ["navigation.depth_m", "supervisor.mode"])
    told = rows(target)
    assert list(told[0]) == ["cycle", "time_s", "time_ns", "navigation.depth_m", "supervisor.mode"]
    table = flight.run.table()
    first = int((table["time_s"] >= 10.0).argmax())
    assert len(told) == 201
    assert float(told[0]["navigation.depth_m"]) == table["navigation.depth_m"][first]
    assert told[0]["supervisor.mode"] == "FORWARD"


def test_what_was_not_told_is_empty(flight: Flight, tmp_path: Path) -> None:
    """Protects from "nan" in a cell: a camera that sees nothing measures nothing."""
    export(flight.path, tmp_path / "run.csv", "csv", Range(0.0, 1.0), ["target.measured_range_m"])
    assert {row["target.measured_range_m"] for row in rows(tmp_path / "run.csv")} == {""}


def test_parquet_is_the_table(flight: Flight, tmp_path: Path) -> None:
    """Protects notebooks: the same columns as `Run.table`, with their types."""
    export(flight.path, tmp_path / "run.parquet", "parquet", Range(), [])
    found = parquet.read_table(tmp_path / "run.parquet")
    table = flight.run.table()
    assert found.column_names == list(table)
    assert found["navigation.depth_m"].to_pylist() == table["navigation.depth_m"].tolist()


def test_alog_speaks_moos(flight: Flight, tmp_path: Path) -> None:
    """Protects MOOS tools: x is east, y is north, headings 0 to 360, events in one line each."""
    export(flight.path, tmp_path / "run.alog", "alog", Range(30.0, 31.0), [])
    lines = (tmp_path / "run.alog").read_text(encoding="utf-8").splitlines()
    assert lines[1] == "%% LOG FILE:       run.alog"
    assert lines[3].startswith("%% LOGSTART")
    said = [line.split(maxsplit=3) for line in lines if not line.startswith("%")]
    table = flight.run.table()
    row = int((table["time_s"] >= 30.0).argmax())
    y = next(value for _, name, _, value in said if name == "NAV_Y")
    assert float(y) == pytest.approx(table["navigation.position_ned_m.x"][row], abs=1e-6)
    headings = [float(value) for _, name, _, value in said if name == "NAV_HEADING"]
    assert all(0.0 <= heading < 360.0 and math.isfinite(heading) for heading in headings)
    assert [value for _, name, _, value in said if name == "BUMPLESS_MODE"] == ["REVERSE"]


def test_an_unknown_signal_names_its_neighbour(flight: Flight, tmp_path: Path) -> None:
    """Protects from a table without the column that was wanted."""
    with pytest.raises(ValueError, match=r"near it is 'navigation\.depth_m'"):
        export(flight.path, tmp_path / "run.csv", "csv", Range(), ["navigaton.depth"])
    with pytest.raises(ValueError, match="chosen for tables"):
        export(flight.path, tmp_path / "run.mcap", "mcap", Range(), ["navigation.*"])
    assert not list(tmp_path.iterdir())
