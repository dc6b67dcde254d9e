"""Where jobs run: a Dask cluster of this machine's own processes, or any scheduler by its address."""

import logging
import multiprocessing
import os
import socket
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING, cast

from bumpless.campaign.prepared import software

if TYPE_CHECKING:
    from distributed import Client, LocalCluster

ANSWER_S = 10.0  # how long a scheduler may take to answer
WORKERS_S = 60.0  # how long the first worker may take to join one


class ClusterError(RuntimeError):
    """No cluster to fly on, or it went away."""


@contextmanager
def opened(address: str | None = None, workers: int | None = None) -> "Iterator[Client]":
    """A client of the scheduler at `address`, or of `workers` processes started here (None: one per core)."""
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what matters is raised
    if address is not None:
        with _reached(address) as client:
            _await_workers(client)
            _compare_software(client)
            yield client
        return
    from distributed import Client

    with _local(workers or os.cpu_count() or 1) as cluster, Client(cluster) as client:
        yield client


@cache
def kept(workers: int) -> "Client":
    """A client of `workers` local processes that stay until this process ends: for many small calls."""
    from distributed import Client

    return Client(_local(workers))


def cores_of(client: "Client") -> int:
    """How many jobs the cluster does at a time."""
    return sum(worker["nthreads"] for worker in client.scheduler_info(n_workers=-1)["workers"].values()) or 1


def _local(workers: int) -> "LocalCluster":
    """Processes, one thread each: a flight holds no GIL while it flies, but its start and its end do."""
    _forked_where_possible()
    from distributed import LocalCluster

    return LocalCluster(
        n_workers=workers,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        scheduler_kwargs={"dashboard": False, "dashboard_address": "127.0.0.1:0"},
        memory_limit=0,
        silence_logs=logging.CRITICAL,
        preload=["bumpless.campaign.preload"],
    )


def _forked_where_possible() -> None:
    """Let workers be forked from one process that has imported and loaded all they need.

    Started on its own, each worker would take seconds of a core for that.
    """
    if sys.platform == "win32" or "forkserver" not in multiprocessing.get_all_start_methods():
        return
    from multiprocessing import forkserver

    from dask.config import set as configure

    multiprocessing.get_context("forkserver").set_forkserver_preload(["bumpless.campaign.forked"])
    forkserver.ensure_running()
    configure({"distributed.worker.multiprocessing-method": "forkserver"})


def _reached(address: str) -> "Client":
    from distributed import Client

    try:
        _knock(address)
        return Client(address, timeout=ANSWER_S, set_as_default=False)
    except (OSError, ValueError) as error:
        raise ClusterError(f"no Dask scheduler answers at {address}: {error}") from error


def _knock(address: str) -> None:
    """Raise at once what Dask would try again until its time is over: nobody listens there."""
    scheme, _, place = address.rpartition("://")
    host, _, port = place.rpartition(":")
    if scheme not in ("", "tcp", "tls") or not host or not port.isdecimal():
        raise ValueError("must be tcp://HOST:PORT or tls://HOST:PORT")
    socket.create_connection((host.strip("[]"), int(port)), ANSWER_S).close()


def _await_workers(client: "Client") -> None:
    try:
        client.wait_for_workers(1, WORKERS_S)
    except TimeoutError as error:
        where = client.scheduler.address if client.scheduler else "the scheduler"
        raise ClusterError(f"no worker has joined {where} within {WORKERS_S:g} s") from error


def _compare_software(client: "Client") -> None:
    """What joins later is compared by each chunk, see `FlyNumbers`."""
    again = "install on the workers what runs here"
    try:
        found = cast("dict[str, str]", client.run(software))  # typed as if it were awaited
    except (ImportError, AttributeError) as error:
        raise ClusterError(f"a worker cannot load this version of Bumpless: {error}; {again}") from error
    for worker, its in found.items():
        if its != software():
            raise ClusterError(f"{worker} has Bumpless {its}, here is {software()}; {again}")
