"""The mission library: files with their history, a bin, drafts and marks. Nothing that was saved is lost."""

import threading
from difflib import unified_diff

from bumpless_server.data_dir import DataDir
from bumpless_server.files import checked_name
from bumpless_server.plan.bin import Bin, Binned
from bumpless_server.plan.drafts import Drafts
from bumpless_server.plan.marks import Mark, Marks
from bumpless_server.plan.missions import ENDINGS, MissionExists, MissionFile, Missions
from bumpless_server.plan.versions import Version, Versions


class NoMission(LookupError):
    """There is no mission, version or deleted mission of that name."""


class Library:
    """What can be done with stored missions; each change is whole before the next begins."""

    def __init__(self, missions: Missions, data: DataDir) -> None:
        self.missions = missions
        self.versions = Versions(data.versions)
        self.bin = Bin(data.bin)
        self.drafts = Drafts(data.drafts)
        self.marks = Marks(data.marks)
        self._lock = threading.RLock()

    def get(self, name: str) -> MissionFile:
        """One mission. Raises NoMission."""
        file = self.missions.get(name)
        if file is None:
            raise NoMission(f"there is no mission {name!r}")
        return file

    def save(self, name: str, data: bytes, replace: bool = True, base: str | None = None) -> MissionFile:
        """Keep a mission's bytes as they are; its draft has served.

        base: hash of the file that was edited; another one there now is somebody else's work, which stays.
        Raises BadName, MissionError or MissionExists.
        """
        with self._lock:
            present = self.missions.get(name)
            if base is not None and (present is None or present.sha256 != base):
                raise MissionExists(f"{name} was changed or deleted by somebody since it was opened")
            if present is not None and not present.builtin and replace:
                self.versions.keep(present.name, present.path.read_bytes(), present.path.stat().st_mtime_ns)
            file = self.missions.save(name, data, replace)
            self.versions.keep(file.name, data)
            self.drafts.drop(file.name)
            return file

    def rename(self, name: str, to: str) -> MissionFile:
        """Give a mission another file name, with its history, draft and marks."""
        with self._lock:
            file, to = self._own(name), self._free(to)
            file.path.rename(file.path.with_name(f"{to}.yaml"))
            self.versions.rename(file.name, to)
            self.marks.move(file.name, to)
            draft = self.drafts.get(file.name)
            if draft is not None:
                self.drafts.put(to, draft.data)
                self.drafts.drop(file.name)
            return self.get(to)

    def duplicate(self, name: str, to: str) -> MissionFile:
        """A copy of a mission's bytes under another file name."""
        with self._lock:
            return self.save(self._free(to), self.get(name).path.read_bytes(), replace=False)

    def delete(self, name: str) -> Binned:
        """Put a mission into the bin."""
        with self._lock:
            file = self._own(name)
            binned = self.bin.put(file.name, file.path.read_bytes())
            self.missions.delete(file.name)
            return binned

    def restore(self, binned: str) -> MissionFile:
        """Take a mission out of the bin; under another name where its own was given anew."""
        with self._lock:
            found = self.bin.read(binned)
            if found is None:
                raise NoMission(f"there is no deleted mission {binned!r}")
            name, data = found
            free = name
            for n in range(2, 1000):
                if self.missions.get(free) is None:
                    break
                free = f"{name[:60]}-{n}"
            file = self.missions.put(free, data)
            self.bin.forget(binned)
            return file

    def mark(self, name: str, tags: tuple[str, ...] | None, archived: bool | None) -> Mark:
        """Change a mission's tags, or put it away and take it out again; None leaves as it is."""
        with self._lock:
            changes = {"tags": tags, "archived": archived}
            given = {key: value for key, value in changes.items() if value is not None}
            return self.marks.set(self.get(name).name, **given)

    def version(self, name: str, version: str) -> bytes:
        """The bytes of one saved version. Raises BadName or NoMission."""
        data = self.versions.read(checked_name(name, *ENDINGS), version)
        if data is None:
            raise NoMission(f"there is no version {version!r} of {name!r}")
        return data

    def difference(self, name: str, before: str, after: str = "") -> str:
        """What changed from one saved version to another, or to the file as it is: a unified diff.

        Raises BadName or NoMission.
        """
        old = self.version(name, before)
        new = self.version(name, after) if after else self.get(name).data
        was, now = (data.decode("utf-8", "replace").splitlines() for data in (old, new))
        return "\n".join(unified_diff(was, now, before, after or "now", lineterm=""))

    def history(self, name: str) -> list[Version]:
        """Every saved version, newest first; also of a mission that was deleted. Raises BadName."""
        return self.versions.all(checked_name(name, *ENDINGS))

    def _own(self, name: str) -> MissionFile:
        file = self.get(name)
        if file.builtin:
            raise MissionExists(f"{file.name} is a built-in mission and stays; duplicate it")
        return file

    def _free(self, name: str) -> str:
        name = checked_name(name, *ENDINGS)
        if self.missions.get(name) is not None:
            raise MissionExists(f"there is a mission {name} already")
        return name
