"""Ways to spoil a text or a log: cut, doubled, flipped, swollen, nested, and what parsers fear."""

import random
import time
from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless.runs.writer import RunWriter

FEARED = (
    "!!python/object/apply:os.system ['true']",
    "&a [*a, *a]",
    "a: &a [x, x]\nb: &b [*a, *a]\nc: &c [*b, *b]\nd: [*c, *c]",
    "[" * 3000,
    "{" * 3000,
    "- " * 5000,
    ".nan",
    "1e999",
    "-9" * 400,
    "0x" + "f" * 5000,
    "\x00",
    "\ud7ff\ufffe",
    "'''",
    '"""' + "a" * 100_000,
    "? : ? :",
    "%YAML 9.9\n---",
    "9999-99-99",
    "<<: *x",
    "key: " + "k" * 200_000,
)


def mutated_text(text: str, draw: random.Random) -> str:
    """A text with one to four things done to it."""
    for _ in range(draw.randint(1, 4)):
        lines = text.splitlines(keepends=True) or [""]
        at = draw.randrange(len(lines))
        what = draw.randrange(7)
        if what == 0:
            del lines[at]
        elif what == 1:
            lines.insert(at, lines[draw.randrange(len(lines))])
        elif what == 2:
            lines.insert(at, draw.choice(FEARED) + "\n")
        elif what == 3:
            head, colon, _ = lines[at].partition(draw.choice(":="))
            lines[at] = f"{head}{colon} {draw.choice(FEARED)}\n"
        elif what == 4:
            lines[at] = lines[at] * draw.choice((2, 50, 2000))
        elif what == 5:
            spot = draw.randrange(len(text) or 1)
            text = text[:spot] + chr(draw.randrange(1, 0xD7FF)) + text[spot + 1 :]
            continue
        else:
            lines = lines[:at]
        text = "".join(lines)
    return text


def mutated_bytes(content: bytes, draw: random.Random) -> bytes:
    """Bytes with one to four things done to them."""
    spoilt = bytearray(content)
    for _ in range(draw.randint(1, 4)):
        at = draw.randrange(max(1, len(spoilt)))
        what = draw.randrange(5)
        if what == 0:
            spoilt[at : at + 1] = bytes((draw.randrange(256),))
        elif what == 1:
            spoilt[at : at + 8] = draw.choice((b"\xff" * 8, b"\x00" * 8, (2**40).to_bytes(8, "little")))
        elif what == 2:
            del spoilt[at : at + draw.randrange(1, 2000)]
        elif what == 3:
            other = draw.randrange(max(1, len(spoilt)))
            spoilt[at:at] = spoilt[other : other + draw.randrange(1, 2000)]
        else:
            del spoilt[at:]
    return bytes(spoilt)


def log_bytes(folder: Path) -> bytes:
    """A small whole log, as the recorder writes it."""
    path, now = folder / "whole.mcap", time.time_ns()
    status = pb.MissionStatus(run_id="whole", phase=pb.MISSION_PHASE_RUNNING, duration_s=3.0)
    status.stamp.time_ns = now
    writer = RunWriter(path, status)
    for cycle in range(60):
        for name, topic in TOPICS.items():
            message = topic.message()
            message.stamp.time_ns, message.stamp.cycle = now + cycle * 50_000_000, cycle  # type: ignore[attr-defined]
            writer.write(f"tlm/{name}", topic.schema, message.SerializeToString(), now + cycle * 50_000_000)
    writer.finish("complete", "completed")
    content = path.read_bytes()
    path.unlink()
    return content
