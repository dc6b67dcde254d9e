"""A router as a plain process: a Zenoh session in mode "router", which is what zenohd holds as well.

python -m tests.node.router ENDPOINT...            open to everybody
python -m tests.node.router --config router.json5   as a configuration file says
"""

import json
import sys
import threading
from pathlib import Path

import zenoh

from bumpless.contract.session import session_file


def configuration(words: list[str]) -> zenoh.Config:
    """Of a router that listens at these endpoints, or as the file after --config says."""
    if words[0] == "--config":
        return session_file(Path(words[1]))
    config = zenoh.Config()
    config.insert_json5("mode", '"router"')
    config.insert_json5("listen/endpoints", json.dumps(words))
    config.insert_json5("scouting/multicast/enabled", "false")
    return config


if __name__ == "__main__":
    with zenoh.open(configuration(sys.argv[1:])):
        print("routing", flush=True)
        threading.Event().wait()
