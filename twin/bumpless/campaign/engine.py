"""The one engine that flies many jobs: in chunks over Dask, each chunk's answers as soon as they are there.

A worker that dies loses only the chunk it had in hand, which another worker flies again.
"""

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from bumpless.campaign.cluster import ClusterError, kept
from bumpless.campaign.ready import ready

if TYPE_CHECKING:
    from distributed import Client

J = TypeVar("J")
A = TypeVar("A")
K = TypeVar("K", bound=Hashable)

ROUNDS = 8  # chunks per worker: enough that the last ones end together
LARGEST_CHUNK = 64


def in_chunks(items: Sequence[J], workers: int, rounds: int = ROUNDS) -> list[list[J]]:
    """`items` cut in their order into chunks, so many `rounds` of them for each of so many workers."""
    size = max(1, min(LARGEST_CHUNK, len(items) // (rounds * max(1, workers))))
    return [list(items[k : k + size]) for k in range(0, len(items), size)]


def answers(
    client: "Client", work: Callable[[list[J]], A], chunks: Mapping[K, list[J]]
) -> Iterator[tuple[K, A]]:
    """(key, work(chunk)) of every chunk, as they come in. An error of `work` is raised here.

    Raises ClusterError when the scheduler goes away or a chunk kills every worker that tries it.
    """
    from distributed import CancelledError, KilledWorker, as_completed
    from distributed.comm.core import CommClosedError

    futures = {client.submit(work, chunk, pure=False): key for key, chunk in chunks.items()}
    try:
        for future in as_completed(list(futures), loop=client.loop):
            key = futures.pop(future)
            yield key, future.result()
            future.release()
    except (CancelledError, CommClosedError, TimeoutError) as error:
        raise ClusterError("the Dask scheduler went away") from error
    except KilledWorker as error:
        raise ClusterError(f"a chunk ended every worker that tried it: {error}") from error
    finally:
        if futures and client.status == "running":
            client.cancel(list(futures), force=True)


class Each:
    """`work` of each job of a chunk: picklable when `work` is."""

    def __init__(self, work: Callable[[Any], Any]) -> None:
        self.work = work

    def __call__(self, jobs: list[Any]) -> list[Any]:
        """The answers, in order."""
        ready()
        return [self.work(job) for job in jobs]


def in_order(
    jobs: Sequence[J],
    work: Callable[[J], A],
    workers: int,
    progress: Callable[[int, int], None] | None = None,
) -> list[A]:
    """`work` of every job, in order, whatever the number of workers; 1 flies in this process.

    progress(done, total) is called as answers come in.
    """
    done: dict[int, list[A]] = {}
    count = 0
    chunks = dict(enumerate(in_chunks(jobs, workers)))
    if workers <= 1:
        chunks = dict(enumerate([job] for job in jobs))
        found: Iterator[tuple[int, list[A]]] = ((key, Each(work)(chunk)) for key, chunk in chunks.items())
    else:
        found = answers(kept(workers), Each(work), chunks)
    for key, part in found:
        done[key] = part
        count += len(part)
        if progress:
            progress(count, len(jobs))
    return [answer for key in sorted(done) for answer in done[key]]
