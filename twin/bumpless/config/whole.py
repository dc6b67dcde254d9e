"""Files that appear whole or not at all: what stood there stays until all of the new one is on the disk."""

import os
import stat
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path


class NotWritten(OSError):
    """A file could not be written: which, and why."""

    def __str__(self) -> str:
        return f"{self.filename}: {self.strerror}"


@contextmanager
def whole(target: Path) -> Generator[Path]:
    """A path to write to, beside `target`; its file takes the place of `target` at the end.

    Where writing fails it is gone again, and `target` is as it was. Raises NotWritten, also where something
    is there that is no ordinary file, such as a device or a pipe: that is not replaced.
    """
    partial = target.with_name(target.name + ".part")
    try:
        if target.exists() and not stat.S_ISREG(target.stat().st_mode):
            what = "is a folder" if target.is_dir() else "is no ordinary file"
            raise NotWritten(None, what, str(target))
        yield partial
        _to_the_disk(partial)
        partial.replace(target)
    except NotWritten:
        raise
    except OSError as error:
        raise NotWritten(error.errno, error.strerror or str(error), str(target)) from error
    finally:
        partial.unlink(missing_ok=True)


def write_text(target: Path, text: str) -> None:
    """Make `target` of `text`, as UTF-8."""
    with whole(target) as partial:
        partial.write_text(text, encoding="utf-8")


def _to_the_disk(path: Path) -> None:
    """Some file systems find out only now that there is no room."""
    with path.open("rb+") as file:
        os.fsync(file.fileno())
