"""Which tests `make test-fast` leaves out: those that open a browser, fly a study or many flights, or build.

Said in one place, by folder or file, and by fixture for browsers; everything else must stay quick.
"""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
BROWSER = {"browser", "chromium_path"}  # fixtures
SLOW = (
    "tests/bench",
    "tests/campaign/test_engine.py",
    "tests/console",
    "tests/paper",
    "tests/stability",
    # whole flights in real time, real processes that are killed, minutes of a node's memory
    "tests/config/vehicle/test_flights.py",
    "tests/control/docking/test_flights.py",
    "tests/identify/test_learned.py",
    "tests/node/test_claim.py",
    "tests/node/test_crash.py",
    "tests/node/test_failsafe.py",
    "tests/node/test_heartbeat.py",
    "tests/node/test_memory.py",
    "tests/node/test_one_vehicle.py",
    "tests/node/test_stalled.py",
    "tests/node/test_three_processes.py",
    "tests/node/test_trusted.py",
    "tests/server/access/test_fuzz.py",
    "tests/server/cli/test_campaign.py",
    "tests/server/cli/test_serve.py",
    "tests/physics/actuators/test_azimuth.py",
    "tests/server/foresight/test_foresight.py",
    "tests/server/keys",
    "tests/server/live/test_gaps.py",
    "tests/server/live/test_holder_lost.py",
    "tests/server/live/test_real_node.py",
    "tests/server/live/test_strangers.py",
    "tests/server/runs/test_recording.py",
    "tests/server/vehicle_process/test_crash.py",
    "tests/server/vehicle_process/test_supervise.py",
    "tests/server/web/test_commanding.py",
    "tests/server/web/test_export_api.py",
    "tests/server/web/test_flight_api.py",
    "tests/server/web/test_missions_api.py",
    "tests/trust",
    # tens of thousands of problems, and code compiled anew
    "tests/control/allocation/test_mdca_optimum.py",
    "tests/control/allocation/test_qp_handles.py",
    "tests/control/allocation/test_qp_optimum.py",
    "tests/jit",
    # packages, pages and releases that are built
    "tests/docs/test_pages.py",
    "tests/infra/test_install.py",
    "tests/infra/test_package.py",
    "tests/infra/test_release.py",
    "tests/server/web/test_help.py",
)


def pytest_configure(config: pytest.Config) -> None:
    """Declare the mark."""
    config.addinivalue_line("markers", "slow: left out by `make test-fast`; tests/slow.py says which and why")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark what is slow."""
    places = tuple(ROOT / place for place in SLOW)
    for item in items:
        opens = BROWSER & set(getattr(item, "fixturenames", ()))
        if opens or any(item.path == place or place in item.path.parents for place in places):
            item.add_marker("slow")
