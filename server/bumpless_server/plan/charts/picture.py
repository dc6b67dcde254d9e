"""Pictures from strangers: opened by what they are, never larger in memory than they may be, and made PNG."""

import io
import struct
from typing import Any

from bumpless.contract.extras import imported
from bumpless_server.plan.charts.content import NotAChart

MOST_PIXELS, WIDEST = 16_000_000, 2048
BROKEN = (  # what Pillow's readers raise at broken files
    OSError, ValueError, SyntaxError, TypeError, KeyError, IndexError, AttributeError, struct.error,
    OverflowError, ZeroDivisionError, MemoryError, EOFError, RuntimeError,
)  # fmt: skip


def opened(data: bytes, *formats: str) -> Any:
    """The picture (a PIL.Image.Image) in one of these formats, its pixels read. Raises NotAChart."""
    imported("PIL", "console")
    from PIL import Image

    try:
        image = Image.open(io.BytesIO(data), formats=formats)
        width, height = image.size
        if width * height > MOST_PIXELS:
            raise NotAChart(f"has {width} x {height} points, more than {MOST_PIXELS}")
        image.load()
    except NotAChart:
        raise
    except (*BROKEN, Image.DecompressionBombError) as error:
        raise NotAChart(f"is a picture that can't be read: {error or type(error).__name__}") from None
    return image


def as_png(image: Any) -> tuple[bytes, str]:
    """(PNG, note): colours with transparency, thinned where it is very wide."""
    from PIL import Image

    note, size = "", image.size
    try:
        image = image.convert("RGBA")
        if max(size) > WIDEST:
            image.thumbnail((WIDEST, WIDEST), Image.Resampling.LANCZOS)
            note = f"shown with {image.size[0]} x {image.size[1]} of its {size[0]} x {size[1]} points"
        out = io.BytesIO()
        image.save(out, "PNG")
    except BROKEN as error:
        raise NotAChart(f"is a picture that can't be shown: {error}") from None
    return out.getvalue(), note
