"""How the server tells something of its own: one function that makes an event of it."""

from collections.abc import Callable

from bumpless.contract import bumpless_pb2 as pb

Say = Callable[[pb.Severity, str, str, dict[str, str]], None]  # severity, code, text, details
