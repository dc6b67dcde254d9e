"""Mission files: those that come with the package, and uploaded ones in the data folder."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from bumpless.config.mission import Mission, MissionError, missions_folder, parse_mission
from bumpless.config.problems import Problem
from bumpless.config.vehicle import Vehicle
from bumpless_server.data_dir import write_whole
from bumpless_server.files import BadName, checked_name, why_no_file
from bumpless_server.live.tally import printable

ENDINGS = (".yaml", ".yml")
MOST_BYTES = 4_000_000


class MissionExists(Exception):
    """There is a mission of that name, and it was not to be replaced."""


@dataclass(frozen=True)
class MissionFile:
    """A stored mission file. `mission` is None when a file put there by hand is faulty."""

    name: str
    path: Path
    builtin: bool
    data: bytes
    mission: Mission | None
    problems: tuple[Problem, ...] = ()

    @property
    def text(self) -> str:
        """The bytes as text; what is no UTF-8 shows as replacement characters."""
        return self.data.decode("utf-8", errors="replace")

    @cached_property
    def sha256(self) -> str:
        """Hash of the bytes, valid or not: the same in the browser, here and on the command line."""
        return hashlib.sha256(self.data).hexdigest()


class Missions:
    """All missions by name (the file's, without .yaml).

    `vehicle` tells which vehicle is on the bus: a mission may be for it though its file is not ours.
    """

    def __init__(
        self,
        uploads: Path,
        builtin: Path | None = None,
        vehicle: Callable[[], Vehicle | None] = lambda: None,
    ) -> None:
        self._uploads = uploads
        self._builtin = builtin or missions_folder()
        self._vehicle = vehicle
        self._read: dict[Path, tuple[tuple[int, int, str], MissionFile]] = {}

    def all(self) -> list[MissionFile]:
        """Built-in missions first, each group by name."""
        paths = [
            path
            for folder in (self._builtin, self._uploads)
            for ending in ENDINGS
            for path in folder.glob(f"*{ending}")
            if not path.name.startswith(".") and not self._why_not(path)
        ]
        found = {path.stem: self._load(path) for path in reversed(paths)}
        return sorted(found.values(), key=lambda file: (not file.builtin, file.name))

    def left_out(self) -> dict[str, str]:
        """Entries of the uploads' folder that are in no list, with the reason."""
        entries = (path for ending in ENDINGS for path in self._uploads.glob(f"*{ending}"))
        told = {printable(path.name): self._why_not(path) for path in entries if path.name[0] != "."}
        return {name: reason for name, reason in sorted(told.items()) if reason}

    @staticmethod
    def _why_not(path: Path) -> str:
        try:
            return why_no_file(path, most_bytes=MOST_BYTES)
        except FileNotFoundError:
            return "it has just gone"

    def get(self, name: str) -> MissionFile | None:
        """One mission; `name` with or without .yaml."""
        try:
            name = checked_name(name, *ENDINGS)
        except BadName:
            return None
        return next((file for file in self.all() if file.name == name), None)

    def save(self, name: str, data: bytes, replace: bool) -> MissionFile:
        """Check an uploaded mission and keep its bytes. Raises BadName, MissionError or MissionExists."""
        name = checked_name(name, *ENDINGS)
        parse_planned(data, f"{name}.yaml", self._vehicle())
        present = self.get(name)
        if present is not None and present.builtin:
            raise MissionExists(f"{name} is a built-in mission; give yours another name")
        if present is not None and not replace:
            raise MissionExists(f"there is a mission {name} already")
        file = self.put(name, data)
        if present is not None and present.path != file.path:
            present.path.unlink(missing_ok=True)
        return file

    def put(self, name: str, data: bytes) -> MissionFile:
        """Write an uploaded mission's bytes, whatever they hold."""
        path = self._uploads / f"{name}.yaml"
        write_whole(path, data)
        return self._load(path)

    def delete(self, name: str) -> bool:
        """Remove an uploaded mission; False when there is none. Raises MissionExists for a built-in one."""
        present = self.get(name)
        if present is None:
            return False
        if present.builtin:
            raise MissionExists(f"{present.name} is a built-in mission and stays")
        present.path.unlink(missing_ok=True)
        return True

    def _load(self, path: Path) -> MissionFile:
        found, vehicle = path.stat(), self._vehicle()
        mark = (found.st_mtime_ns, found.st_size, vehicle.sha256 if vehicle else "")
        cached = self._read.get(path)
        if cached is not None and cached[0] == mark:
            return cached[1]
        builtin = path.parent == self._builtin
        data = b""
        try:
            data = path.read_bytes()
            file = MissionFile(path.stem, path, builtin, data, parse_planned(data, path.name, vehicle))
        except MissionError as error:
            file = MissionFile(path.stem, path, builtin, data, None, error.problems)
        except Exception as error:  # whatever one odd file makes of its reader, the others stay in the list
            why = getattr(error, "strerror", None) or f"{type(error).__name__}: {error}"
            problem = Problem(path.name, None, None, "", None, printable(f"cannot be read: {why}"))
            file = MissionFile(path.stem, path, builtin, data, None, (problem,))
        self._read[path] = (mark, file)
        return file


def parse_planned(data: bytes | str, source: str, present: Vehicle | None) -> Mission:
    """Check a mission against the vehicle file of the name it asks for, or the present vehicle's own."""
    try:
        return parse_mission(data, source)
    except MissionError as error:
        unknown = [one.value for one in error.problems if one.field == "vehicle"]
        if present is None or present.id not in unknown:
            raise
        return parse_mission(data, source, present)
