"""The track: constant memory, whole history, little traffic."""

import numpy as np

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene.palette import FORWARD, HOVER, vertex_colour
from bumpless_server.scene.trail import CHUNK, Track, TrailView


class _Node:
    def __init__(self) -> None:
        self.points = self.colors = None
        self.visible = False


class _Scene:
    def add_line_segments(self, *_: object, **__: object) -> _Node:
        return _Node()


def _fly(track: Track, metres: float, step: float = 0.05, mode: int = pb.MODE_FORWARD) -> None:
    for s in np.arange(0.0, metres, step):
        track.add(np.array([s, 0.0, 2.0]), mode)


def test_memory_is_constant_and_the_whole_track_stays() -> None:
    """However long the flight, the arrays are those of the start and reach from first to last position."""
    track = Track(chunks=2)
    points = track.points
    _fly(track, 500.0)
    assert track.points is points
    assert track.count <= 2 * CHUNK + 1
    assert track.points[0, 0] == 0.0
    assert track.points[track.count - 1, 0] > 500.0 - 2.0 * track.spacing_m
    steps = np.diff(track.points[: track.count, 0])
    assert steps.max() < 2.1 * track.spacing_m


def test_only_the_live_chunk_is_sent() -> None:
    """While the vehicle moves a little, one chunk of many goes out; when it rests, none."""
    track = Track(chunks=20)
    view = TrailView(_Scene(), track)
    _fly(track, 100.0, step=0.1)
    assert view.draw() > 5
    assert track.add(np.array([100.2, 0.0, 2.0]), pb.MODE_FORWARD)
    assert view.draw() == 1
    assert not track.add(np.array([100.21, 0.0, 2.0]), pb.MODE_FORWARD)
    assert view.draw() == 0


def test_chunks_join_without_gaps() -> None:
    """The last point of a chunk is the first of the next; unused segments have no length."""
    track = Track(chunks=3)
    _fly(track, 15.0, step=0.1)
    first, _ = track.chunk(0)
    second, _ = track.chunk(1)
    np.testing.assert_array_equal(first[-1, 1], second[0, 0])
    np.testing.assert_array_equal(second[-1, 0], second[-1, 1])


def test_segments_have_the_modes_colour() -> None:
    """The console's colours: blue in F, green in H."""
    track = Track(chunks=1)
    _fly(track, 1.0, step=0.2)
    track.add(np.array([2.0, 0.0, 2.0]), pb.MODE_HOVER)
    _, colours = track.chunk(0)
    assert tuple(colours[0, 0]) == vertex_colour(FORWARD)
    assert tuple(colours[track.count - 2, 1]) == vertex_colour(HOVER)


def test_clear_empties_the_picture() -> None:
    """A new run does not show the old one's track."""
    track = Track(chunks=2)
    view = TrailView(_Scene(), track)
    _fly(track, 5.0)
    view.draw()
    track.clear()
    view.draw()
    assert not any(node.visible for node in view.nodes)
