"""The engine on a real cluster of two processes."""

import operator
import os
import signal
from functools import partial
from typing import Any

import pytest

from bumpless.campaign import cluster as cluster_module
from bumpless.campaign.cluster import ClusterError, opened
from bumpless.campaign.engine import answers, in_chunks, in_order
from bumpless.campaign.flight import FlyNumbers, OtherSoftware
from bumpless.campaign.fly import fly_missing
from bumpless.campaign.store import opened as store
from tests.ports import free_port


def test_chunks_hold_every_item_once_in_order():
    """Protects: nothing is left out or done twice, whatever the number of items and workers."""
    for count in (0, 1, 7, 100, 5000):
        for workers in (1, 2, 16):
            chunks = in_chunks(range(count), workers)
            assert [item for chunk in chunks for item in chunk] == list(range(count))


def test_answers_come_in_the_order_of_the_jobs():
    """Protects: the study's tables; two processes give what one gives, in the same order."""
    seen = []
    two = in_order(range(40), operator.neg, 2, lambda done, total: seen.append((done, total)))
    assert two == in_order(range(40), operator.neg, 1) == [-k for k in range(40)]
    assert seen[-1] == (40, 40)
    assert seen == sorted(seen)


def test_an_error_of_a_job_is_raised(cluster):
    """Protects: a flight that cannot be flown ends the campaign with its error, not with a gap."""
    with pytest.raises(ZeroDivisionError):
        list(answers(cluster, partial(map_list, 1), {0: [1], 1: [0]}))


def map_list(over, chunk):
    """Work that fails on a zero."""
    return [over / item for item in chunk]


def test_two_processes_fly_as_one_does(campaign, cluster):
    """Protects: a flight depends on its number alone, not on worker, chunk or what flew before it."""
    prepared, numbers = campaign(12), [7, 0, 3, 11, 4]
    alone = {row["number"]: row for number in numbers for row in FlyNumbers(prepared)([number])}
    chunks = {0: [11, 7], 1: [0, 4, 3]}
    flown = {row["number"]: row for _, rows in answers(cluster, FlyNumbers(prepared), chunks) for row in rows}
    assert repr(flown) == repr({number: alone[number] for number in flown})
    assert flown.keys() == alone.keys()


def test_a_dead_worker_loses_nothing(campaign, tmp_path):
    """Protects: kill -9 of a worker in mid-flight; its chunk is flown again and no flight counts twice."""
    prepared = campaign(64)
    killed = []
    with store(tmp_path, prepared, False) as kept, opened(workers=2) as client:

        def kill(_):
            if not killed:
                pids: Any = client.run(os.getpid)
                killed.append(next(iter(pids.values())))
                os.kill(killed[0], signal.SIGKILL)

        fly_missing(prepared, kept, client, kill)
        assert kept.table().column("number").to_pylist() == list(range(64))
    assert killed


def test_no_scheduler_there():
    """Protects: a wrong --dask is said in a line."""
    with pytest.raises(ClusterError, match="no Dask scheduler answers at nowhere"), opened("nowhere://x"):
        pass


def test_nobody_at_the_address_is_said_at_once():
    """Protects: a refused connection was tried again for ten seconds, and nonsense was a traceback."""
    with pytest.raises(ClusterError, match="Connection refused"), opened(f"tcp://127.0.0.1:{free_port()}"):
        pass
    for nonsense in ("nonsense", "http://127.0.0.1:80", "tcp://host", ""):
        with pytest.raises(ClusterError, match="must be tcp://HOST:PORT"), opened(nonsense):
            pass


def test_a_scheduler_without_workers_is_said(monkeypatch):
    """Protects: a campaign waited for ever, at 0 of its flights, for workers that nobody had started."""
    monkeypatch.setattr(cluster_module, "WORKERS_S", 0.1)
    from distributed import LocalCluster

    dask = {"n_workers": 0, "processes": False, "dashboard_address": None, "host": "127.0.0.1"}
    empty = LocalCluster(**dask, protocol="tcp")  # type: ignore[arg-type]
    with empty, pytest.raises(ClusterError, match="no worker has"):
        with opened(empty.scheduler_address):
            pass


def test_another_software_flies_nothing(campaign, cluster, monkeypatch):
    """Protects: workers of another version flew other flights, which were stored as this campaign's."""
    work = FlyNumbers(campaign(2))
    work.software = "0.0 of another state"
    with pytest.raises(OtherSoftware, match=r"this program 0\.0 of another state"):
        list(answers(cluster, work, {0: [0, 1]}))
    monkeypatch.setattr(cluster_module, "software", os.getpid)  # another on each
    with pytest.raises(ClusterError, match="install on the workers what runs here"):
        cluster_module._compare_software(cluster)
