"""Twenty consoles, two of which have stalled: the short form of `make bench-consoles`, without real time."""

import asyncio

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless_server.live.sample import Sample
from bumpless_server.live.state import State
from bumpless_server.live.stream import KEPT, Stream

CONSOLES, STALLED, CYCLES = 20, 2, 40
MANY = 500


def cycle(number: int) -> list[Sample]:
    """All topics of one control cycle."""
    stamp = pb.Stamp(cycle=number)
    return [
        Sample(f"tlm/{name}", kind.schema, kind.message(stamp=stamp).SerializeToString(), receive_ns=number)
        for name, kind in TOPICS.items()
    ]


async def test_each_console_sees_every_cycle_and_two_that_stalled_cost_nothing() -> None:
    """Protects: a stalled browser holds up nobody, and its buffer does not grow with time."""
    state, released = State("ts100"), asyncio.Event()
    stream = Stream(state)
    seen: list[list[int]] = [[] for _ in range(CONSOLES - STALLED)]
    news = asyncio.Condition()

    def console(cycles: list[int]):
        async def send(frame: bytes) -> None:
            for message in pb.StreamFrame.FromString(frame).messages:
                if message.topic == "tlm/navigation":
                    cycles.append(pb.Navigation.FromString(message.payload).stamp.cycle)
            async with news:
                news.notify_all()

        return send

    async def stalled(_frame: bytes) -> None:
        await released.wait()

    sends = [*map(console, seen), *[stalled] * STALLED]
    tasks = [asyncio.create_task(stream.serve(send)) for send in sends]
    while len(stream) < CONSOLES:
        await asyncio.sleep(0)
    for number in range(1, CYCLES + 1):
        for sample in cycle(number):
            state.feed(sample)
        async with news:
            await news.wait_for(lambda now=number: all(cycles and cycles[-1] == now for cycles in seen))
    assert all(cycles == list(range(1, CYCLES + 1)) for cycles in seen)
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)


async def test_what_waits_for_stalled_consoles_does_not_grow() -> None:
    """Protects: memory after hours of a stalled browser is that after a second."""
    state = State("ts100")
    stream = Stream(state)
    clients = [stream.join() for _ in range(STALLED)]
    for number in range(MANY):
        for sample in cycle(number):
            state.feed(sample)
    for client in clients:
        assert client.replaced == (MANY - KEPT) * len(TOPICS)
        assert len(client.take()) == KEPT * len(TOPICS)
