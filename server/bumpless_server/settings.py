"""Every setting of the server, with its default: BUMPLESS_<NAME> in the environment, or an option."""

import difflib
import ipaddress
import os
import shlex
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError, ValidationInfo, field_validator, model_validator
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

from bumpless.contract import keys

PREFIX = "BUMPLESS_"
LOCAL_BUS = "tcp/127.0.0.1:7447"
LISTS = ("zenoh_listen", "zenoh_connect", "allowed_hosts", "proxies", "node_command")  # may be empty
# Read by other parts: the tests, the compiler cache, the build.
NOT_SETTINGS = frozenset({"BUMPLESS_CHROMIUM", "BUMPLESS_CACHE_DIR", "BUMPLESS_SKIP_CONSOLE"})

GONE = {
    "BUMPLESS_TOKEN": "is gone: people have accounts (bumpless user add NAME --role engineer), scripts have "
    "tokens (bumpless user token NAME); the old secret may be the first password "
    "(BUMPLESS_FIRST_PASSWORD_FILE)"
}

Names = Annotated[tuple[str, ...], NoDecode]  # written "a,b" in the environment
Command = Annotated[tuple[str, ...], NoDecode]  # written as in a shell


class SettingsError(ValueError):
    """A setting is unknown or does not hold; the text has one line for each."""


class Settings(BaseSettings):
    """The server's settings. Frozen: a changed setting is a new server."""

    model_config = SettingsConfigDict(env_prefix=PREFIX, extra="forbid", frozen=True)

    host: str = Field(
        default="127.0.0.1", description="address to serve on; only loopback is open without accounts"
    )
    port: int = Field(default=8080, ge=0, le=65535, description="port to serve on; 0 takes a free one")
    data_dir: Path = Field(default=Path("data"), description="runs, uploaded missions and presets")
    vehicle: str = Field(default="ts100", description="vehicle id, or the path of a vehicle file (.toml)")
    manage_node: bool = Field(default=True, description="start the vehicle node, and again when it dies")
    node_command: Command = Field(
        default=(), description="program to start as the vehicle node instead of this package's own"
    )
    zenoh_listen: Names = Field(
        default=(LOCAL_BUS,),
        description="endpoints where the server's bus session listens; none where it connects, by default",
    )
    zenoh_connect: Names = Field(default=(), description="endpoints the server's bus session connects to")
    zenoh_config: Path | None = Field(
        default=None,
        description="Zenoh configuration of the server's bus session, such as `bumpless keys` makes;"
        " instead of the endpoints",
    )
    node_zenoh_config: Path | None = Field(
        default=None, description="the same for the vehicle node that the server starts"
    )
    scene: Literal["full", "light", "off"] = Field(
        default="full", description="the 3-D scene; light draws fewer polygons for machines without a GPU"
    )
    tls_cert: Path | None = Field(
        default=None, description="certificate chain (PEM) to serve HTTPS with; needs tls_key"
    )
    tls_key: Path | None = Field(default=None, description="private key (PEM) of tls_cert")
    proxies: Names = Field(
        default=(),
        description="addresses or networks of reverse proxies that end TLS and say so (X-Forwarded-Proto)",
    )
    plain_http: bool = Field(
        default=False,
        description="serve beyond loopback without TLS: only where the port is published to loopback alone",
    )
    session_hours: float = Field(
        default=12.0, gt=0, le=720, description="a login that is not used for so long is over"
    )
    first_password_file: Path | None = Field(
        default=None,
        description="file with the password of the account `engineer`, made when there is no account yet",
    )
    allowed_hosts: Names = Field(
        default=(), description="further host names the console is reached by, such as a reverse proxy's"
    )
    command_timeout_s: float = Field(
        default=5.0, gt=0, le=60, description="how long a vehicle may take to answer"
    )
    recorder_queue_messages: int = Field(
        default=20_000, ge=1, description="messages that may wait for the disk"
    )
    recorder_queue_bytes: int = Field(
        default=64_000_000, ge=1, description="bytes that may wait for the disk"
    )
    runs_max_bytes: int = Field(
        default=0, ge=0, description="bytes that all recorded runs may take; 0 sets no limit"
    )
    runs_prune: bool = Field(
        default=False,
        description="with runs_max_bytes: delete the oldest complete runs to make room, else stop recording",
    )
    disk_free_bytes: int = Field(
        default=200_000_000, ge=0, description="free bytes on the disk below which nothing is recorded"
    )
    upload_bytes: int = Field(
        default=8_000_000,
        ge=1,
        description="largest body of a request: mission file, preset, another program's mission",
    )
    import_bytes: int = Field(
        default=2_000_000_000, ge=1, description="largest log that may be brought into the list of runs"
    )

    tiles: str = Field(
        default="",
        pattern=r"^$|^https?://[^\s\"'<>]*\{z\}[^\s\"'<>]*$",
        max_length=400,
        description="address of a base map's tiles under plans, with {z}, {x} and {y}; browsers then fetch "
        "them from there; none: no tiles",
    )
    tiles_attribution: str = Field(
        default="", max_length=200, description="what the tiles' maker wants to be read on the map"
    )

    @field_validator("zenoh_listen", "zenoh_connect", "allowed_hosts", "proxies", mode="before")
    @classmethod
    def _split_names(cls, value: Any) -> Any:
        return (
            [part.strip() for part in value.split(",") if part.strip()] if isinstance(value, str) else value
        )

    @model_validator(mode="before")
    @classmethod
    def _no_setting_is_empty(cls, values: Any) -> Any:
        """An empty value says nothing: neither the default nor an empty token may be what somebody meant."""
        for name, value in values.items() if isinstance(values, dict) else ():
            if value == "" and name not in LISTS:
                raise ValueError(f"{PREFIX}{name.upper()} is empty; give it a value or leave it out")
        return values

    @model_validator(mode="after")
    def _one_bus_is_enough(self) -> "Settings":
        """A router on this machine has our port already; where we connect to one, nobody connects to us."""
        if (self.zenoh_connect or self.zenoh_config) and "zenoh_listen" not in self.model_fields_set:
            object.__setattr__(self, "zenoh_listen", ())
        return self

    @model_validator(mode="after")
    def _a_configuration_says_it_all(self) -> "Settings":
        """Two sources for one session would contradict each other, and the node must not borrow our keys."""
        if self.zenoh_config is None:
            return self
        if self.zenoh_listen or self.zenoh_connect:
            raise ValueError("zenoh_config says all of the bus: leave zenoh_listen and zenoh_connect out")
        if self.manage_node and self.node_zenoh_config is None and not self.node_command:
            raise ValueError("with zenoh_config the node needs keys of its own: give node_zenoh_config,"
                             " or manage_node=false")  # fmt: skip
        return self

    @field_validator("node_command", mode="before")
    @classmethod
    def _split_command(cls, value: Any) -> Any:
        return shlex.split(value) if isinstance(value, str) else value

    @field_validator("vehicle")
    @classmethod
    def _vehicle_is_nameable(cls, value: str) -> str:
        return value if value.endswith(".toml") else keys.check_vehicle_id(value)

    @field_validator("proxies")
    @classmethod
    def _proxies_are_addresses(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        for one in value:
            ipaddress.ip_network(one)  # "*" would let anybody say that its connection is safe
        return value

    @model_validator(mode="after")
    def _secrets_stay_secret(self) -> "Settings":
        """Passwords and cookies travel beyond this machine only where nobody can read them."""
        if (self.tls_cert is None) != (self.tls_key is None):
            raise ValueError("tls_cert and tls_key belong together: give both or none")
        if not (self.loopback or self.tls_cert or self.proxies or self.plain_http):
            raise ValueError(
                f"beyond loopback ({self.host}) passwords need TLS: give tls_cert and tls_key, or proxies "
                "(the addresses of a reverse proxy that ends TLS), or plain_http=true where the port is "
                "published to loopback alone"
            )
        return self

    @field_validator("runs_prune")
    @classmethod
    def _pruning_has_a_limit(cls, value: bool, info: ValidationInfo) -> bool:
        if value and info.data.get("runs_max_bytes") == 0:
            raise ValueError("needs runs_max_bytes: without a limit nothing is ever too much")
        return value

    @property
    def vehicle_id(self) -> str:
        """The id on the bus: the setting itself, or what the vehicle file says."""
        if not self.vehicle.endswith(".toml"):
            return self.vehicle
        from bumpless.config.vehicle import load_vehicle

        return load_vehicle(self.vehicle).id

    @property
    def accounts_needed(self) -> bool:
        """True when others than this machine's people can reach the server."""
        return not self.loopback or bool(self.proxies) or bool(self.allowed_hosts)

    @property
    def loopback(self) -> bool:
        """True when only this machine can reach the server."""
        if self.host == "localhost":
            return True
        try:
            return ipaddress.ip_address(self.host).is_loopback
        except ValueError:
            return False


def load_settings(**given: Any) -> Settings:
    """Settings from the environment, with `given` (None: not given) on top.

    Raises SettingsError naming each unknown or wrong setting, its value and what would be right.
    """
    known = {PREFIX + name.upper(): name for name in Settings.model_fields}
    lines = []
    for variable in sorted(os.environ):
        if variable.upper().startswith(PREFIX) and variable.upper() not in known.keys() | NOT_SETTINGS:
            if variable.upper() in GONE:
                lines.append(f"{variable}: {GONE[variable.upper()]}")
                continue
            near = difflib.get_close_matches(variable.upper(), known, n=1)
            lines.append(f"{variable}: no such setting" + (f"; did you mean {near[0]}?" if near else ""))
    if lines:
        raise SettingsError("\n".join(lines))
    try:
        return Settings(**{name: value for name, value in given.items() if value is not None})
    except ValidationError as error:
        for fault in error.errors(include_url=False):
            if not fault["loc"]:
                lines.append(fault["msg"].removeprefix("Value error, "))
                continue
            name = str(fault["loc"][0])
            source = name if given.get(name) is not None else PREFIX + name.upper()
            lines.append(f"{source} = {fault['input']!r}: {fault['msg'].removeprefix('Value error, ')}")
        raise SettingsError("\n".join(lines)) from error
