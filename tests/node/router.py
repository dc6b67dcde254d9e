"""A router as a plain process: a Zenoh session in mode "router", which is what zenohd holds as well."""

import json
import sys
import threading

import zenoh

if __name__ == "__main__":
    config = zenoh.Config()
    config.insert_json5("mode", '"router"')
    config.insert_json5("listen/endpoints", json.dumps(sys.argv[1:]))
    config.insert_json5("scouting/multicast/enabled", "false")
    with zenoh.open(config):
        print("routing", flush=True)
        threading.Event().wait()
