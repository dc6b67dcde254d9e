"""Every setting of the server, with its default: BUMPLESS_<NAME> in the environment, or an option."""

import difflib
import ipaddress
import os
import shlex
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, SecretStr, ValidationError, ValidationInfo, field_validator, model_validator
from pydantic_settings import BaseSettings, NoDecode, SettingsConfigDict

from bumpless.contract import keys

PREFIX = "BUMPLESS_"
LOCAL_BUS = "tcp/127.0.0.1:7447"
LISTS = ("zenoh_listen", "zenoh_connect", "allowed_hosts", "node_command")  # may be empty
# Read by other parts: the tests, the compiler cache, the build.
NOT_SETTINGS = frozenset({"BUMPLESS_CHROMIUM", "BUMPLESS_CACHE_DIR", "BUMPLESS_SKIP_CONSOLE"})

Names = Annotated[tuple[str, ...], NoDecode]  # written "a,b" in the environment
Command = Annotated[tuple[str, ...], NoDecode]  # written as in a shell


class SettingsError(ValueError):
    """A setting is unknown or does not hold; the text has one line for each."""


class Settings(BaseSettings):
    """The server's settings. Frozen: a changed setting is a new server."""

    model_config = SettingsConfigDict(env_prefix=PREFIX, extra="forbid", frozen=True)

    host: str = Field(
        default="127.0.0.1", description="address to serve on; only loopback is open without a token"
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
    scene: Literal["full", "light", "off"] = Field(
        default="full", description="the 3-D scene; light draws fewer polygons for machines without a GPU"
    )
    token: SecretStr | None = Field(
        default=None, description="shared secret a browser must give once; needed beyond loopback"
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

    @field_validator("zenoh_listen", "zenoh_connect", "allowed_hosts", mode="before")
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
        if self.zenoh_connect and "zenoh_listen" not in self.model_fields_set:
            object.__setattr__(self, "zenoh_listen", ())
        return self

    @field_validator("node_command", mode="before")
    @classmethod
    def _split_command(cls, value: Any) -> Any:
        return shlex.split(value) if isinstance(value, str) else value

    @field_validator("vehicle")
    @classmethod
    def _vehicle_is_nameable(cls, value: str) -> str:
        return value if value.endswith(".toml") else keys.check_vehicle_id(value)

    @field_validator("token")
    @classmethod
    def _token_is_long(cls, value: SecretStr | None) -> SecretStr | None:
        if value is not None and len(value.get_secret_value()) < 8:
            raise ValueError("must have at least 8 characters")
        return value

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
            shown = "" if name == "token" else f" = {fault['input']!r}"
            lines.append(f"{source}{shown}: {fault['msg'].removeprefix('Value error, ')}")
        raise SettingsError("\n".join(lines)) from error
