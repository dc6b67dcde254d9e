"""What the figures were measured on."""

import os
import platform
import re
import threading
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path


def describe() -> dict[str, str]:
    """Processor, cores, load, and the versions that matter."""
    packages = {}
    for name in ("numba", "numpy", "scipy", "osqp", "daqp", "qpsolvers", "casadi", "auv-sim-bench"):
        try:
            packages[name] = version(name)
        except PackageNotFoundError:
            continue
    return {
        "processor": _processor(),
        "cores": str(os.cpu_count()),
        "load average": f"{os.getloadavg()[0]:.1f}",
        "system": f"{platform.system()}, Python {platform.python_version()}",
        "real-time scheduling": "granted" if _real_time() else "not granted",
        "packages": ", ".join(f"{name} {number}" for name, number in packages.items()),
    }


def _real_time() -> bool:
    """Whether this user's live node gets SCHED_FIFO: without it lateness is that of any other process."""
    granted = []

    def ask() -> None:  # on a thread of its own, which takes the policy with it
        try:
            os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))
            granted.append(True)
        except (AttributeError, OSError):
            pass

    thread = threading.Thread(target=ask)
    thread.start()
    thread.join()
    return bool(granted)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    found = re.search(r"model name\s*:\s*(.+)", info.read_text()) if info.exists() else None
    return found[1].strip() if found else platform.processor() or platform.machine()
