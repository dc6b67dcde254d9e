"""A node that came back from a crash gets what the operator had tuned it with."""

import contextlib
from concurrent.futures import Future

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live.desk import Busy, Command, Desk
from bumpless_server.live.told import Say
from bumpless_server.live.tuned import Tuned


def tune_again(tuned: Tuned, desk: Desk, say: Say) -> None:
    """Send it, where the present node lacks it, and tell what came of it."""
    parameters = tuned.forgotten()
    if parameters is None:
        return

    def told(future: "Future[pb.CommandReply]") -> None:
        error = future.exception()
        reply = pb.CommandReply(reason=str(error)) if error else future.result()
        if reply.accepted:
            text = "The vehicle node came back; it flies with the parameters of before again"
            say(pb.SEVERITY_INFO, "parameters_restored", text, {"revision": str(reply.revision)})
        else:
            text = f"The vehicle node came back with its defaults and not as tuned: {reply.reason}"
            say(pb.SEVERITY_ALARM, "parameters_not_restored", text, {})

    with contextlib.suppress(Busy, RuntimeError):
        desk.submit(Command("set_parameters", parameters, author="server")).add_done_callback(told)
