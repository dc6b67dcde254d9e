"""The commands and their options: what each says of itself when asked for help."""

import inspect
from collections.abc import Callable
from typing import Any

import typer
from typer.testing import CliRunner

from bumpless_server.cli.main import app
from docs.generate.markdown import NOTE

HEAD = """# Commands

What `bumpless COMMAND --help` says in the terminal. From a checkout the program is `.venv/bin/bumpless`.
Every command but `serve` and `vehicle` ends by itself; most take `--json`.

"""
WIDTH = {"COLUMNS": "100", "TERMINAL_WIDTH": "100", "NO_COLOR": "1", "TERM": "dumb"}


def commands() -> dict[str, Callable[..., Any]]:
    """Name -> function, in the order of `bumpless --help`; those of a group behind its name."""
    made = _of(app, "")
    for group in app.registered_groups:
        made |= _of(group.typer_instance, f"{group.name} ")
    return made


def _of(group: typer.Typer | None, before: str) -> dict[str, Callable[..., Any]]:
    found = [(one.name, one.callback) for one in group.registered_commands if one.callback] if group else []
    return {before + (name or function.__name__).replace("_", "-"): function for name, function in found}


def help_of(command: str) -> str:
    """The text of `bumpless COMMAND --help`."""
    done = CliRunner().invoke(app, [*command.split(), "--help"], env=WIDTH, prog_name="bumpless")
    if done.exit_code != 0:
        raise RuntimeError(f"bumpless {command} --help: {done.output}")
    return inspect.cleandoc(done.output)


def page() -> str:
    """Markdown: a chapter per command."""
    chapters = (f"## {name}\n\n```text\n{help_of(name)}\n```\n" for name in commands())
    return NOTE + HEAD + "\n".join(chapters)
