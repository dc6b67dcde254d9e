"""How the vehicle node is started: this package's own command, with this interpreter."""

import sys

from bumpless_server.data_dir import DataDir
from bumpless_server.settings import Settings

ANY_ADDRESS = ("0.0.0.0", "[::]")  # where a session may listen, but not what one connects to


def node_command(settings: Settings) -> tuple[str, ...]:
    """Command line of the vehicle node that connects to this server's bus."""
    if settings.node_command:
        return settings.node_command
    # -P: what lies in the working directory is no part of the node
    command = [sys.executable, "-P", "-m", "bumpless_server.cli.main", "vehicle", settings.vehicle]
    command += ["--memory", str(DataDir(settings.data_dir).flight)]
    if settings.node_zenoh_config is not None:
        return (*command, "--zenoh-config", str(settings.node_zenoh_config))
    for endpoint in settings.zenoh_listen or settings.zenoh_connect:
        for address in ANY_ADDRESS:
            endpoint = endpoint.replace(f"/{address}:", "/127.0.0.1:")
        command += ["--connect", endpoint]
    return tuple(command)
