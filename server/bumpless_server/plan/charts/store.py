"""Charts in the data folder: one archive each, with the file as it came and what was read of it."""

import hashlib
import io
import json
import threading
import zipfile
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from functools import lru_cache
from pathlib import Path
from typing import Any

from bumpless.chart import DepthGrid, NotAGrid, from_bytes, to_bytes, with_floor
from bumpless.config.mission import Mission
from bumpless_server.data_dir import write_whole
from bumpless_server.files import BadName, checked_name, why_no_file
from bumpless_server.live.tally import printable
from bumpless_server.plan.charts.content import Content, Corners, Feature, Kind, NotAChart, Said
from bumpless_server.plan.charts.read import read_chart

ENDING, MOST, MOST_BYTES = ".chart", 100, 64_000_000
_ABOUT, _ORIGINAL, _CONTENT = "about.json", "original", "content"
_BROKEN = (OSError, ValueError, KeyError, TypeError, zipfile.BadZipFile, RuntimeError, NotAGrid)


class NoChart(LookupError):
    """There is no chart of that name."""


class TooManyCharts(Exception):
    """Some have to be deleted first."""


@dataclass(frozen=True)
class Chart:
    """What is known of a stored chart without its content."""

    name: str
    kind: Kind
    format: str
    file_name: str
    size: int
    sha256: str
    stored: datetime
    geographic: bool
    title: str = ""
    missions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    corners: Corners | None = None

    @property
    def saved_as(self) -> str:
        """A file name for the original that is safe in a header."""
        kept = "".join(c for c in self.file_name if c.isascii() and (c.isalnum() or c in "._-"))
        return kept.lstrip(".") or self.name


class Charts:
    """All charts by name."""

    def __init__(self, folder: Path) -> None:
        self._folder, self._lock = folder, threading.Lock()

    def all(self) -> list[Chart]:
        """Every chart that can be read, by name."""
        found = (_about(path, _mark(path)) for path in self._paths())
        return [chart for chart in found if isinstance(chart, Chart)]

    def left_out(self) -> dict[str, str]:
        """Entries of the folder that are in no list, with the reason."""
        told = {}
        for path in sorted(self._folder.glob(f"*{ENDING}")):
            if path.name.startswith("."):
                continue
            reason = why_no_file(path, most_bytes=MOST_BYTES) or _about(path, _mark(path))
            if isinstance(reason, str):
                told[printable(path.name)] = reason
        return told

    def get(self, name: str) -> Chart:
        """One chart. Raises NoChart."""
        path = self._path(name)
        found = _about(path, _mark(path)) if path is not None else "is not there"
        if not isinstance(found, Chart):
            raise NoChart(f"there is no chart {name!r}")
        return found

    def put(self, name: str, data: bytes, file_name: str, said: Said = Said()) -> Chart:  # noqa: B008
        """Read and keep a chart. Raises BadName, NotAChart or TooManyCharts."""
        name = checked_name(name, ENDING)
        content = read_chart(data, said)
        with self._lock:
            old = next((chart for chart in self.all() if chart.name == name), None)
            if old is None and len(self._paths()) >= MOST:
                raise TooManyCharts(f"there are {MOST} charts; delete some first")
            chart = Chart(
                name,
                content.kind,
                content.format,
                printable(file_name),
                len(data),
                hashlib.sha256(data).hexdigest(),
                datetime.now(UTC).replace(microsecond=0),
                content.geographic,
                title=old.title if old else "",
                missions=old.missions if old else (),
                notes=content.notes,
                corners=content.corners,
            )
            self._write(chart, data, _packed(content))
        return chart

    def own(self, name: str, title: str | None, missions: tuple[str, ...] | None) -> Chart:
        """Give a chart another title or other missions; None leaves as it is."""
        with self._lock:
            chart = self.get(name)
            changes: dict[str, Any] = {"title": title, "missions": missions}
            chart = replace(chart, **{key: value for key, value in changes.items() if value is not None})
            self._write(chart, self._member(name, _ORIGINAL), self._member(name, _CONTENT))
            return chart

    def mission_renamed(self, name: str, to: str) -> None:
        """A mission has another name: what belonged to it still does."""
        for chart in self.all():
            if name in chart.missions:
                self.own(chart.name, None, tuple(to if one == name else one for one in chart.missions))

    def delete(self, name: str) -> None:
        """Remove a chart. Raises NoChart."""
        path = self._path(self.get(name).name)
        if path is not None:
            path.unlink(missing_ok=True)

    def original(self, name: str) -> bytes:
        """The file as it came. Raises NoChart."""
        return self._member(self.get(name).name, _ORIGINAL)

    def picture(self, name: str) -> bytes:
        """PNG. Raises NoChart, also where the chart is no picture."""
        if self.get(name).kind != "picture":
            raise NoChart(f"the chart {name!r} is no picture")
        return self._member(name, _CONTENT)

    def features(self, name: str) -> tuple[Feature, ...]:
        """Shapes; none of other kinds. Raises NoChart."""
        if self.get(name).kind != "features":
            return ()
        told = json.loads(self._member(name, _CONTENT))
        return tuple(Feature(one["kind"], one["parts"], one["name"], one["colour"]) for one in told)

    def grid(self, name: str) -> DepthGrid | None:
        """The depth grid of that name; None where there is none."""
        path = self._path(name)
        return _grid(path, _mark(path)) if path is not None else None

    def laid(self, mission: Mission) -> Mission:
        """The mission with the depth grid that it names, where there is one; itself where it names none."""
        said = mission.sea_floor
        if said is None or not said.grid:
            return mission
        return with_floor(mission, self.grid(said.grid))

    def _paths(self) -> list[Path]:
        found = self._folder.glob(f"*{ENDING}")
        return [p for p in sorted(found) if p.name[0] != "." and not why_no_file(p, most_bytes=MOST_BYTES)]

    def _path(self, name: str) -> Path | None:
        try:
            path = self._folder / f"{checked_name(name, ENDING)}{ENDING}"
        except BadName:
            return None
        return path if path.is_file() else None

    def _member(self, name: str, member: str) -> bytes:
        path = self._path(name)
        try:
            if path is None:
                raise NoChart(name)
            return _read(path, member)
        except _BROKEN as error:
            raise NoChart(f"the chart {name!r} cannot be read: {error}") from error

    def _write(self, chart: Chart, original: bytes, content: bytes) -> None:
        out = io.BytesIO()
        about = {**asdict(chart), "stored": chart.stored.isoformat()}
        with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(_ABOUT, json.dumps(about, indent=1, ensure_ascii=False))
            archive.writestr(_CONTENT, content, zipfile.ZIP_STORED)
            archive.writestr(_ORIGINAL, original)
        write_whole(self._folder / f"{chart.name}{ENDING}", out.getvalue())


def _packed(content: Content) -> bytes:
    if content.grid is not None:
        return to_bytes(content.grid)
    if content.kind == "picture":
        return content.picture
    return json.dumps([asdict(one) for one in content.features]).encode()


def _mark(path: Path) -> tuple[int, int]:
    try:
        found = path.stat()
    except OSError:
        return 0, 0
    return found.st_mtime_ns, found.st_size


def _read(path: Path, member: str) -> bytes:
    with zipfile.ZipFile(path) as archive, archive.open(member) as file:
        data = file.read(MOST_BYTES + 1)
    if len(data) > MOST_BYTES:
        raise ValueError(f"{member} is larger than {MOST_BYTES} bytes")
    return data


@lru_cache(maxsize=256)
def _about(path: Path, _mark: tuple[int, int]) -> Chart | str:
    """The chart of a file; why it is none otherwise."""
    try:
        told = json.loads(_read(path, _ABOUT))
        corners = told["corners"]
        told |= {
            "name": path.stem,
            "stored": datetime.fromisoformat(told["stored"]),
            "missions": tuple(told["missions"]),
            "notes": tuple(told["notes"]),
            "corners": tuple(tuple(place) for place in corners) if corners else None,
        }
        return Chart(**told)
    except _BROKEN as error:
        return f"it is no chart that can be read: {printable(str(error))}"


@lru_cache(maxsize=8)
def _grid(path: Path, _mark: tuple[int, int]) -> DepthGrid | None:
    try:
        chart = _about(path, _mark)
        if not isinstance(chart, Chart) or chart.kind != "depths":
            return None
        return from_bytes(_read(path, _CONTENT))
    except _BROKEN:
        return None


__all__ = ["Chart", "Charts", "NoChart", "NotAChart", "TooManyCharts"]
