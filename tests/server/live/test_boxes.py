"""The queues between threads: they never grow beyond their bounds and never lose a decision."""

import threading

from hypothesis import given
from hypothesis import strategies as st

from bumpless_server.live.boxes import MAX_KEPT, BoundedQueue


@given(st.lists(st.integers(0, 40), max_size=200), st.integers(1, 20), st.integers(1, 200))
def test_never_beyond_its_bounds_and_every_loss_is_counted(sizes: list[int], items: int, total: int) -> None:
    """A stuck reader costs old messages, not memory; what is left are the newest, in order."""
    queue: BoundedQueue[tuple[int, int]] = BoundedQueue(items, total, size=lambda item: item[1])
    for number, size in enumerate(sizes):
        queue.put((number, size))
    left = queue.take(0)
    assert len(left) <= items
    assert sum(size for _, size in left) <= total or len(left) == 1
    assert queue.dropped == len(sizes) - len(left)
    assert [number for number, _ in left] == list(range(len(sizes) - len(left), len(sizes)))


def test_items_to_keep_come_out_first_and_in_order() -> None:
    """An overflow must not make the recorder miss that a run has begun or ended."""
    queue: BoundedQueue[str] = BoundedQueue(3, 10**6, size=len, keep=lambda item: item.startswith("!"))
    for item in ("!start", "a", "b", "!end", "c", "d", "e"):
        queue.put(item)
    assert queue.take(0) == ["!start", "!end", "c", "d", "e"]
    assert queue.dropped == 2


def test_kept_items_are_bounded_too() -> None:
    """Even decisions do not pile up without end behind a disk that never returns."""
    queue: BoundedQueue[int] = BoundedQueue(1, 10**6, size=lambda _: 1, keep=lambda _: True)
    for number in range(1000):
        queue.put(number)
    assert len(queue) == MAX_KEPT + 1


def test_close_wakes_the_reader_and_lets_it_take_the_rest() -> None:
    """Stopping the server writes what is queued and then ends."""
    queue: BoundedQueue[int] = BoundedQueue(10, 100, size=lambda _: 1)
    taken: list[int] = []

    def read() -> None:
        while not queue.closed:
            taken.extend(queue.take(None))

    reader = threading.Thread(target=read)
    reader.start()
    queue.put(1)
    queue.put(2)
    queue.close()
    reader.join()
    assert taken == [1, 2]
