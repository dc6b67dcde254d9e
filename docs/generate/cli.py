"""The commands and their options: what each says of itself when asked for help."""

import inspect
from collections.abc import Callable
from typing import Any

from typer.testing import CliRunner

from bumpless_server.cli.main import app
from docs.generate.markdown import NOTE

HEAD = """# Commands

What `bumpless COMMAND --help` says in the terminal. From a checkout the program is `.venv/bin/bumpless`.
Every command but `serve` and `vehicle` ends by itself; most take `--json`.

"""
WIDTH = {"COLUMNS": "100", "TERMINAL_WIDTH": "100", "NO_COLOR": "1", "TERM": "dumb"}


def commands() -> dict[str, Callable[..., Any]]:
    """Name -> function, in the order of `bumpless --help`."""
    made = [(one.name, one.callback) for one in app.registered_commands if one.callback is not None]
    return {(name or function.__name__).replace("_", "-"): function for name, function in made}


def help_of(command: str) -> str:
    """The text of `bumpless COMMAND --help`."""
    done = CliRunner().invoke(app, [command, "--help"], env=WIDTH, prog_name="bumpless")
    if done.exit_code != 0:
        raise RuntimeError(f"bumpless {command} --help: {done.output}")
    return inspect.cleandoc(done.output)


def page() -> str:
    """Markdown: a chapter per command."""
    chapters = (f"## {name}\n\n```text\n{help_of(name)}\n```\n" for name in commands())
    return NOTE + HEAD + "\n".join(chapters)
