"""The folder of a fleet's keys: the authority, and for each party one file that holds all it needs.

authority.crt, authority.key   the authority; the key signs further parties and leaves this folder never
fleet.json                     who belongs to it, and where its router is
router.json5, users.txt        for the router: its configuration, and the passwords
server.json5, vehicle.ts100.json5, observer.ashore.json5   for each of the others
"""

import base64
import json
import os
import secrets
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from bumpless.contract import names
from bumpless.contract.session import settings_of
from bumpless_server.keys.access import NAMED, ROLES, Party, access_control
from bumpless_server.keys.authority import Credentials, new_authority, sign_party

PORT = 7447
ROUTER = "router"
PASSWORD_BYTES = 24
USERS = "users.txt"


class KeysError(ValueError):
    """Keys can't be made; one line says why."""


@dataclass(frozen=True)
class Fleet:
    """Who belongs together. `hosts` are the router's names and addresses, the first is what others dial."""

    hosts: tuple[str, ...]
    port: int
    users_at: str  # where the router finds users.txt
    passwords: dict[str, str]  # by common name

    @property
    def parties(self) -> list[Party]:
        """All but the router."""
        return [Party(*common_name.split(".", 1)) for common_name in self.passwords]


def init(
    folder: Path, hosts: Sequence[str], vehicles: Sequence[str], observers: Sequence[str], port: int = PORT,
    users_at: str = "",
) -> list[Path]:  # fmt: skip
    """Make a new fleet in `folder`: the files written. Raises KeysError, also where there is one already."""
    if (folder / "fleet.json").exists() or (folder / "authority.key").exists():
        raise KeysError(f"{folder}: there are keys already; `bumpless keys add` adds a party to them")
    if not hosts:
        raise KeysError("a router needs a name or an address by which others reach it")
    parties = [
        Party("server"),
        *(Party("vehicle", v) for v in vehicles),
        *(Party("observer", o) for o in observers),
    ]
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    authority = new_authority()
    users = users_at or str((folder / USERS).resolve())
    fleet = Fleet(tuple(hosts), port, users, {_checked(p).common_name: _password() for p in parties})
    written = [
        _write(folder / "authority.key", authority.key),
        _write(folder / "authority.crt", authority.certificate),
        _write_router(folder, fleet, authority, sign_party(authority, ROUTER, hosts)),
    ]
    written += [_write_party(folder, fleet, authority, party) for party in parties]
    return written + _write_fleet(folder, fleet)


def add(folder: Path, party: Party) -> list[Path]:
    """Add a party to the fleet in `folder`: the files written, the router's among them. Raises KeysError."""
    fleet, authority = read(folder)
    if _checked(party).common_name in fleet.passwords:
        raise KeysError(f"{party.common_name} has keys already; remove it first to make new ones")
    fleet.passwords[party.common_name] = _password()
    written = [_write_party(folder, fleet, authority, party)]
    return written + _renew_router(folder, fleet)


def remove(folder: Path, party: Party) -> list[Path]:
    """Take a party's rights; the router, started anew with its files, lets it in no more. Or KeysError."""
    fleet, _ = read(folder)
    if fleet.passwords.pop(party.common_name, None) is None:
        raise KeysError(f"{party.common_name} is not of this fleet")
    (folder / f"{party.common_name}.json5").unlink(missing_ok=True)
    return _renew_router(folder, fleet)


def read(folder: Path) -> tuple[Fleet, Credentials]:
    """The fleet in `folder` and its authority. Raises KeysError."""
    try:
        told = json.loads((folder / "fleet.json").read_text())
        fleet = Fleet(tuple(told["hosts"]), int(told["port"]), str(told["users_at"]), dict(told["passwords"]))
        authority = Credentials(
            (folder / "authority.key").read_bytes(), (folder / "authority.crt").read_bytes()
        )
    except OSError as error:
        raise KeysError(f"{folder}: there are no keys; `bumpless keys init` makes them ({error})") from error
    except (ValueError, KeyError, TypeError) as error:
        raise KeysError(f"{folder / 'fleet.json'} can't be read: {error}") from error
    return fleet, authority


def _renew_router(folder: Path, fleet: Fleet) -> list[Path]:
    """The router keeps its certificate: only who may do what has changed."""
    at = folder / "router.json5"
    config = json.loads(_without_head(at.read_text()))
    config["access_control"] = access_control(fleet.parties)
    return [_write_json(at, ROUTER, config), *_write_fleet(folder, fleet)]


def _write_router(folder: Path, fleet: Fleet, authority: Credentials, own: Credentials) -> Path:
    config = settings_of("router", listen=[f"tls/0.0.0.0:{fleet.port}"])
    config["transport"]["link"]["tls"] = _tls(authority, own, "listen")
    config["transport"]["auth"] = {"usrpwd": {"user": None, "dictionary_file": fleet.users_at}}
    config["access_control"] = access_control(fleet.parties)
    return _write_json(folder / "router.json5", ROUTER, config)


def _write_party(folder: Path, fleet: Fleet, authority: Credentials, party: Party) -> Path:
    host = fleet.hosts[0]
    at = f"tls/[{host}]:{fleet.port}" if ":" in host else f"tls/{host}:{fleet.port}"
    # A router passes nothing between two peers; one peer, the server, opens without waiting for its router.
    mode = "peer" if party.role == "server" else "client"
    config = settings_of(mode, connect=[at], timestamps=party.role == "vehicle")
    config["scouting"]["gossip"] = {"enabled": False}
    config["transport"]["link"]["tls"] = _tls(authority, sign_party(authority, party.common_name), "connect")
    password = fleet.passwords[party.common_name]
    config["transport"]["auth"] = {"usrpwd": {"user": party.common_name, "password": password}}
    return _write_json(folder / f"{party.common_name}.json5", party.common_name, config)


def _write_fleet(folder: Path, fleet: Fleet) -> list[Path]:
    users = "".join(f"{name}:{password}\n" for name, password in fleet.passwords.items())
    told = json.dumps(asdict(fleet), indent=1).encode() + b"\n"
    return [_write(folder / USERS, users.encode()), _write(folder / "fleet.json", told)]


def _tls(authority: Credentials, own: Credentials, side: str) -> dict[str, Any]:
    """Everything inline: one file to carry, and no paths that are another machine's."""
    inline = {
        "root_ca_certificate": authority.certificate,
        f"{side}_private_key": own.key,
        f"{side}_certificate": own.certificate,
    }
    return {
        "enable_mtls": True,
        "close_link_on_expiration": True,
        **{f"{name}_base64": base64.b64encode(pem).decode() for name, pem in inline.items()},
    }


def _checked(party: Party) -> Party:
    if party.role not in ROLES:
        raise KeysError(f"{party.role!r} is no role; roles are {', '.join(ROLES)}")
    if party.role in NAMED:
        try:
            names.VEHICLE.check(party.name, party.role)
        except names.BadName as error:
            raise KeysError(str(error)) from error
    return party


def _password() -> str:
    return secrets.token_urlsafe(PASSWORD_BYTES)


_HEAD = "// Zenoh configuration of {}: holds a private key, keep it to yourself. Made by `bumpless keys`.\n"


def _without_head(text: str) -> str:
    return "".join(line for line in text.splitlines(keepends=True) if not line.startswith("//"))


def _write_json(path: Path, name: str, config: dict[str, Any]) -> Path:
    return _write(path, (_HEAD.format(name) + json.dumps(config, indent=1) + "\n").encode())


def _write(path: Path, content: bytes) -> Path:
    """Written whole, and readable by its owner alone from the first byte on."""
    half = path.with_name(path.name + ".half")
    half.unlink(missing_ok=True)
    with os.fdopen(os.open(half, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as file:
        file.write(content)
    half.replace(path)
    return path
