"""`python -m bumpless_server.what_if.worker`: a worker of foresight's kind with work of its own."""

from collections.abc import Callable, Iterator

from bumpless.campaign.ready import ready
from bumpless.config.problems import ProblemsError
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS
from bumpless.review.ahead import Present, ahead
from bumpless_server.foresight.tasks import Told
from bumpless_server.foresight.worker import main
from bumpless_server.what_if.told import AheadFlight, AheadPair, AheadTask


class AheadWork:
    """Flies a draft, and what is in force, from where the vehicle is."""

    def __init__(self, newer: Callable[[], bool]) -> None:
        self._newer = newer

    def read(self, line: bytes) -> AheadTask:
        """The task of a line."""
        return AheadTask.model_validate_json(line)

    def answers(self, task: AheadTask) -> Iterator[tuple[Told, str]]:
        """One pair of flights; nothing for a task that only gets it ready."""
        ready()
        if task.said:
            yield "ahead", _pair(task).model_dump_json(by_alias=True)


def _pair(task: AheadTask) -> AheadPair:
    try:
        latest = {
            name: TOPICS[name].message.FromString(bytes.fromhex(said)) for name, said in task.said.items()
        }
        present = Present.of(latest)
        draft = present.drafted(pb.Parameters.FromString(bytes.fromhex(task.draft)))
        both = [ahead(present, one, task.horizon_s) for one in (None, draft)]
    except (ProblemsError, ValueError) as error:
        return AheadPair(problem=str(error))
    as_it_is, drafted = (AheadFlight.model_validate(one) for one in both)
    return AheadPair(as_it_is=as_it_is, draft=drafted)


if __name__ == "__main__":
    main(AheadWork)
