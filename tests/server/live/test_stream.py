"""The way to the browser: newest of each topic, every event, the bus's own bytes, nobody slowed by others."""

import asyncio
import base64
import itertools
import os
import socket
from statistics import median

import psutil
import pytest
from websockets.sync.client import connect

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.sample import EVENT, Sample
from bumpless_server.live.state import State
from bumpless_server.live.stream import FRAME_PERIOD_S, KEPT, MAX_EVENTS, PLOTTED, Stream
from tests.server.serving import PATIENCE_S, Running


def sample(topic: str, number: int) -> Sample:
    payload = pb.Event(code=str(number)).SerializeToString()
    return Sample(topic, "bumpless.Event", payload, receive_ns=number)


def numbers(frame: bytes, topic: str) -> list[int]:
    messages = pb.StreamFrame.FromString(frame).messages
    return [int(pb.Event.FromString(m.payload).code) for m in messages if m.topic == topic]


async def test_a_blocked_browser_costs_few_messages_per_topic_and_delays_nobody() -> None:
    """The frozen browser's buffer stays small, the other gets everything in time."""
    state = State("ts100")
    stream = Stream(state)
    released, blocked_frames, free_frames = asyncio.Event(), [], []
    got = asyncio.Event()

    async def blocked(frame: bytes) -> None:
        blocked_frames.append(frame)
        await released.wait()

    async def free(frame: bytes) -> None:
        free_frames.append(frame)
        got.set()

    tasks = [asyncio.create_task(stream.serve(send)) for send in (blocked, free)]
    state.feed(sample("tlm/navigation", 0))
    await asyncio.sleep(0)
    for number in range(1, 6):
        got.clear()
        for _ in range(100):
            state.feed(sample("tlm/navigation", number))
        state.feed(sample(EVENT, number))
        await got.wait()
    assert [n for frame in free_frames for n in numbers(frame, EVENT)] == [1, 2, 3, 4, 5]
    assert numbers(free_frames[-1], "tlm/navigation") == [5] * KEPT
    assert len(blocked_frames) == 1
    got.clear()
    released.set()
    while len(blocked_frames) < 2:
        await asyncio.sleep(FRAME_PERIOD_S)
    assert numbers(blocked_frames[1], "tlm/navigation") == [5] * KEPT
    assert numbers(blocked_frames[1], EVENT)[-1] == 5
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)
    assert len(stream) == 0


async def test_a_browser_that_keeps_up_misses_no_cycle() -> None:
    """Protects: frames that drifted against the vehicle skipped 2.4 % of all cycles for every browser."""
    state = State("ts100")
    stream = Stream(state)
    frames: list[bytes] = []
    enough = asyncio.Event()

    async def send(frame: bytes) -> None:
        frames.append(frame)
        if sum(len(numbers(one, "tlm/navigation")) for one in frames) >= 60:
            enough.set()

    task = asyncio.create_task(stream.serve(send))
    for number in range(60):  # at twice the pace of the frames
        state.feed(sample("tlm/navigation", number))
        await asyncio.sleep(FRAME_PERIOD_S / 2)
    await enough.wait()
    task.cancel()
    assert [n for frame in frames for n in numbers(frame, "tlm/navigation")] == list(range(60))


async def test_a_new_browser_begins_with_the_last_two_minutes() -> None:
    """Plots of a reloaded page are not empty; what is kept for them is bounded and never live-looking."""
    state = State("ts100")
    stream = Stream(state)
    step = int(0.05e9)
    for cycle in range(20 * 300):  # five minutes
        for topic in PLOTTED:
            state.feed(Sample(topic, "bumpless.Event", b"", receive_ns=cycle * step))
    past = stream.past()
    times = [frame[0].receive_ns * 1e-9 for frame in past]
    assert times[-1] - times[0] == pytest.approx(120, abs=0.5)
    assert max(b - a for a, b in itertools.pairwise(times)) < 0.5  # a longer gap would break the lines
    assert all([sample.topic for sample in frame] == list(PLOTTED) for frame in past)


async def test_a_browser_that_was_late_gets_what_it_missed_in_coarser_steps() -> None:
    """Protects plots of a busy machine from stripes: a stretch that only this browser missed is no gap."""
    state = State("ts100")
    stream = Stream(state)
    released, frames, got = asyncio.Event(), list[bytes](), asyncio.Event()
    step = int(0.05e9)

    def cycle(number: int) -> None:
        for topic in PLOTTED:
            state.feed(Sample(topic, "bumpless.Event", b"", receive_ns=number * step))

    async def send(frame: bytes) -> None:
        frames.append(frame)
        got.set()
        if len(frames) == 2:
            await released.wait()

    task = asyncio.create_task(stream.serve(send))
    await asyncio.sleep(0)
    for number in (1, 2):
        got.clear()
        cycle(number)
        await got.wait()
    for number in range(3, 203):  # ten seconds of which it reads nothing
        cycle(number)
    released.set()
    while max(told(frames, "tlm/navigation")) < 202 * step:
        await asyncio.sleep(FRAME_PERIOD_S)
    task.cancel()
    times = told(frames, "tlm/navigation")
    assert times == sorted(set(times)), "in order, none twice"
    assert max(b - a for a, b in itertools.pairwise(times)) < 0.5e9
    assert any(pb.StreamFrame.FromString(frame).past for frame in frames)


def told(frames: list[bytes], topic: str) -> list[int]:
    """When the messages of a topic were received, in the order in which they were sent."""
    parsed = [pb.StreamFrame.FromString(frame) for frame in frames]
    return [m.receive_time_ns for frame in parsed for m in frame.messages if m.topic == topic]


async def test_events_of_a_frozen_browser_are_bounded() -> None:
    """Even events do not pile up without end; the newest stay."""
    state = State("ts100")
    client = Stream(state).join()
    for number in range(MAX_EVENTS * 3):
        state.feed(sample(EVENT, number))
    assert [s.receive_ns for s in client.take()] == list(range(MAX_EVENTS * 2, MAX_EVENTS * 3))


async def test_no_more_than_25_frames_a_second_however_fast_the_bus_is() -> None:
    """Frames are counted on the event loop's own clock: between two of them lie 40 ms."""
    state = State("ts100")
    stream = Stream(state)
    loop, times, enough = asyncio.get_running_loop(), [], asyncio.Event()

    async def send(_frame: bytes) -> None:
        times.append(loop.time())
        if len(times) == 8:
            enough.set()

    task = asyncio.create_task(stream.serve(send))
    while not enough.is_set():
        state.feed(sample("tlm/navigation", len(times)))
        await asyncio.sleep(0.001)
    task.cancel()
    # the middle one: a busy machine may take the process's time from it between clock and frame
    assert median(b - a for a, b in itertools.pairwise(times)) >= FRAME_PERIOD_S * 0.98


def test_a_new_browser_gets_the_last_value_of_every_topic_as_the_bus_said_it(running: Running) -> None:
    """The first frame fills the whole screen, and its bytes are the vehicle's."""
    state = running.console.state
    running.until(
        lambda: {"tlm/mission", "tlm/parameters", "server/status"} <= {s.topic for s in state.samples()}
    )
    before = {s.topic: s for s in state.samples()}
    with connect(f"ws://127.0.0.1:{running.port}/api/stream") as browser:
        first = pb.StreamFrame.FromString(browser.recv(timeout=PATIENCE_S, decode=False))
        got = {m.topic: m for m in first.messages}
        assert before.keys() <= got.keys()
        assert "event" in got  # why the screen looks as it does: the last events come along
        assert got["tlm/description"].schema == "bumpless.VehicleDescription"
        same = [m for t, m in got.items() if t in before and m.receive_time_ns == before[t].receive_ns]
        assert same and all(m.payload == before[m.topic].payload for m in same)
        running.until(lambda: running.console.status().stream_clients == 1)
    running.until(lambda: running.console.status().stream_clients == 0)


def frozen_browser(port: int) -> socket.socket:
    """A WebSocket client that shakes hands and then never reads again."""
    raw = socket.socket()
    raw.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    raw.connect(("127.0.0.1", port))
    key = base64.b64encode(os.urandom(16)).decode()
    raw.sendall(
        f"GET /api/stream HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
    )
    return raw


def test_a_frozen_browser_makes_nothing_grow_and_nobody_wait(running: Running) -> None:
    """200 MB pass by a browser that does not read: memory stays, another browser gets the newest."""
    console, process = running.console, psutil.Process()
    filler = os.urandom(400_000)
    with (
        frozen_browser(running.port),
        connect(f"ws://127.0.0.1:{running.port}/api/stream", max_size=None) as browser,
    ):
        running.until(lambda: len(console.stream) == 2)
        before = process.memory_info().rss
        for _ in range(500):
            last = Sample("server/filler", "bumpless.Plan", filler, from_vehicle=False)
            console.dispatcher.sample(last)
            running.until(lambda last=last: console.state.sample("server/filler") is last)
        newest = 0
        while newest < last.receive_ns:
            frame = pb.StreamFrame.FromString(browser.recv(timeout=PATIENCE_S, decode=False))
            newest = max([newest, *(m.receive_time_ns for m in frame.messages if m.topic == "server/filler")])
        assert process.memory_info().rss - before < 60_000_000
        assert running.http.get("/api/health").status_code == 200
