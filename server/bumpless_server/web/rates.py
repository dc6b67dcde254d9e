"""How old the last message of a topic may be before it no longer counts as present, for an ordinary vehicle.

What a vehicle with another control period is given stands in each ServerStatus.
"""

from bumpless.contract.keys import TOPICS
from bumpless_server.live import freshness
from bumpless_server.live.dispatch import STATUS_PERIOD_S
from bumpless_server.live.sample import ALARMS, CONTROL, STATUS


def fresh_for_s() -> dict[str, float]:
    """Seconds by topic of the stream. What comes once a cycle is late when the link is."""
    fresh = {f"tlm/{topic.name}": freshness.fresh_for_s(topic) for topic in TOPICS.values()}
    return fresh | {
        STATUS: freshness.PATIENCE_PERIODS * STATUS_PERIOD_S,
        ALARMS: 1e9,  # these come when they change
        CONTROL: 1e9,
    }
