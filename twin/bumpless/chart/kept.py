"""A depth grid as bytes of our own: small, the same for the same grid, and read without any other package."""

import json
import struct
import zlib

import numpy as np

from bumpless.chart.grid import MOST_CELLS, DepthGrid, NotAGrid

_MAGIC = b"BUMPLESSGRID1\n"
_PLACES = ("north", "west", "step_north", "step_east", "geographic")


def to_bytes(grid: DepthGrid) -> bytes:
    """A head in JSON with its length before it, then the depths as packed float32."""
    rows, columns = grid.depth_m.shape
    told = {name: getattr(grid, name) for name in _PLACES}
    head = json.dumps({"rows": rows, "columns": columns, **told}).encode()
    return (
        _MAGIC + struct.pack("<I", len(head)) + head + zlib.compress(grid.depth_m.astype("<f4").tobytes(), 6)
    )


def from_bytes(data: bytes) -> DepthGrid:
    """The grid. Raises NotAGrid."""
    if not data.startswith(_MAGIC):
        raise NotAGrid("is no depth grid of ours")
    try:
        at = len(_MAGIC) + 4
        length = struct.unpack("<I", data[len(_MAGIC) : at])[0]
        told = json.loads(data[at : at + length])
        rows, columns = int(told["rows"]), int(told["columns"])
        if not 0 < rows * columns <= MOST_CELLS:
            raise NotAGrid(f"says that it has {rows} rows of {columns}")
        packed = zlib.decompressobj()
        unpacked = packed.decompress(data[at + length :], 4 * rows * columns + 1)
        if not packed.eof:
            raise NotAGrid("is a depth grid that is cut off or too long")
        depths = np.frombuffer(unpacked, "<f4").reshape(rows, columns)
        return DepthGrid(depths, **{name: told[name] for name in _PLACES})
    except NotAGrid:
        raise
    except (ValueError, KeyError, TypeError, struct.error, zlib.error) as error:
        raise NotAGrid(f"is a depth grid that is broken: {error}") from None
