"""How old the last message of each topic is, and how old it may be before it no longer counts as present."""

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS, Topic
from bumpless_server.live.link import STALE_AFTER_S
from bumpless_server.live.state import State

PATIENCE_PERIODS = 2.5  # of a topic that is slower than the control cycle
NOMINAL_PERIOD_S = 0.05  # of a vehicle that has not described itself


def fresh_for_s(topic: Topic, period_s: float = NOMINAL_PERIOD_S) -> float:
    """Seconds for which a message of `topic` counts, from a vehicle with this control period."""
    if topic.rate_hz is not None:
        return PATIENCE_PERIODS / topic.rate_hz
    return stale_after_s(period_s)


def stale_after_s(period_s: float) -> float:
    """Silence after which a vehicle with this control period is late; slow ones are given their time."""
    return max(STALE_AFTER_S, PATIENCE_PERIODS * period_s)


def freshness(state: State) -> list[pb.TopicFreshness]:
    """Every topic of the contract, heard or not."""
    description = state.latest("description")
    period_s = description.control_period_s if isinstance(description, pb.VehicleDescription) else 0.0
    told = []
    for topic in TOPICS.values():
        age, fresh = state.age_s(topic.name), fresh_for_s(topic, period_s or NOMINAL_PERIOD_S)
        heard = age != float("inf")
        told.append(
            pb.TopicFreshness(
                topic=f"tlm/{topic.name}",
                age_s=age if heard else -1.0,
                fresh_for_s=fresh,
                late=not heard or age > fresh,
            )
        )
    return told
