"""`bumpless user`: who may use a console beyond this machine, and the tokens of scripts."""

import os
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

user = typer.Typer(
    help="Accounts and tokens of a console. A running server takes changes over at once.",
    no_args_is_help=True,
    rich_markup_mode=None,
)

Name = Annotated[str, typer.Argument(help="Name of the account.")]
Data = Annotated[Path | None, typer.Option(help="The server's data folder.  [default: data]")]
RoleName = Annotated[str, typer.Option(help="observer, operator or engineer.")]
PasswordFile = Annotated[
    Path | None, typer.Option(help="File with the password, - for the input; asked for by default.")
]


def _accounts(data_dir: Path | None) -> Any:
    from bumpless_server.cli.extras import need

    need("console", "argon2", "pydantic_settings")
    from bumpless_server.access.accounts import Accounts
    from bumpless_server.data_dir import DataDir
    from bumpless_server.settings import PREFIX, Settings

    default = os.environ.get(f"{PREFIX}DATA_DIR") or Settings.model_fields["data_dir"].default
    return Accounts(DataDir(data_dir or Path(default)).access)


def _password(name: str, file: Path | None) -> str:
    """Never an argument: others see those in the list of processes."""
    if file is None:
        return typer.prompt(f"Password of {name}", hide_input=True, confirmation_prompt=True)
    text = sys.stdin.read() if str(file) == "-" else file.read_text(encoding="utf-8")
    return text.strip()


def _done(action: Any) -> Any:
    """Do it; a fault is one line and ends with 1."""
    from bumpless_server.access.accounts import AccountsError

    try:
        return action()
    except (AccountsError, OSError, ValueError) as error:
        typer.echo(f"bumpless: {error}", err=True)
        raise typer.Exit(1) from error


@user.command("add")
def add(
    name: Name,
    role: RoleName = "operator",
    password_file: PasswordFile = None,
    data_dir: Data = None,
) -> None:
    """Make an account. The first one must be an engineer's."""
    accounts = _accounts(data_dir)
    _done(lambda: accounts.add(name, role, _password(name, password_file)))
    typer.echo(f"{name} is {role} now.")


@user.command("list")
def list_(data_dir: Data = None) -> None:
    """Accounts and tokens."""
    accounts = _accounts(data_dir)
    for one in accounts.all():
        typer.echo(f"{one.name:<20} {one.role}")
    for token in accounts.tokens():
        typer.echo(f"token {token.name!r} of {token.user}, {token.role}, id {token.id}")


@user.command("remove")
def remove(name: Name, data_dir: Data = None) -> None:
    """Remove an account; its sessions and tokens end with it."""
    accounts = _accounts(data_dir)
    _done(lambda: accounts.remove(name))
    typer.echo(f"{name} is removed.")


@user.command("role")
def role(
    name: Name,
    role: Annotated[str, typer.Argument(help="observer, operator or engineer.")],
    data_dir: Data = None,
) -> None:
    """Give an account another role; its sessions end."""
    accounts = _accounts(data_dir)
    _done(lambda: accounts.change(name, role=role))
    typer.echo(f"{name} is {role} now.")


@user.command("password")
def password(name: Name, password_file: PasswordFile = None, data_dir: Data = None) -> None:
    """Give an account another password; its sessions end."""
    accounts = _accounts(data_dir)
    _done(lambda: accounts.change(name, password=_password(name, password_file)))
    typer.echo(f"The password of {name} is changed.")


@user.command("token")
def token(
    name: Annotated[str, typer.Argument(help="Name of the token, or with --revoke its name or id.")],
    of: Annotated[str | None, typer.Option("--user", help="The account that it belongs to.")] = None,
    role: RoleName = "operator",
    days: Annotated[float, typer.Option(help="Days it is in force; 0: until it is revoked.", min=0.0)] = 365,
    revoke: Annotated[bool, typer.Option("--revoke", help="End the token instead.")] = False,
    data_dir: Data = None,
) -> None:
    """Make a token for a script, which sends it as `Authorization: Bearer TOKEN`. Printed this once."""
    accounts = _accounts(data_dir)
    if revoke:
        ended = _done(lambda: accounts.revoke(name))
        typer.echo(f"The token {ended.name!r} is revoked.")
        return
    if of is None:
        typer.echo("bumpless: --user says whose token it is", err=True)
        raise typer.Exit(2)
    _, secret = _done(lambda: accounts.new_token(of, name, role, days))
    typer.echo(secret)
