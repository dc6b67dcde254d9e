"""Whether this process can compute attainable sets without a pause.

Their first computation loads or compiles code for seconds. A recorder must not wait for that, or a
server killed meanwhile would lose more than its last second: it asks here and leaves them out till then.
"""

import logging
import threading

log = logging.getLogger(__name__)

_lock = threading.Lock()
_ready = threading.Event()
_started = False


def envelopes_ready() -> bool:
    """True when they take milliseconds. The first question starts the preparation on its own thread."""
    global _started
    with _lock:
        if not _started:
            _started = True
            threading.Thread(target=_prepare, name="envelopes", daemon=True).start()
    return _ready.is_set()


def _prepare() -> None:
    from bumpless.config.vehicle import load_vehicle, vehicle_names
    from bumpless.physics.envelope import attainable_sets
    from bumpless.physics.model import build_model

    try:
        attainable_sets(build_model(load_vehicle(vehicle_names()[0])), 0.5, 10)
        _ready.set()
    except Exception:
        log.exception("attainable sets cannot be computed; logs go without them")
