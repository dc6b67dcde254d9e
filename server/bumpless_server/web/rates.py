"""How old the last message of a topic may be before it no longer counts as present."""

from bumpless.contract.keys import TOPICS
from bumpless_server.live.dispatch import STATUS_PERIOD_S
from bumpless_server.live.link import STALE_AFTER_S
from bumpless_server.live.sample import ALARMS, STATUS

PATIENCE_PERIODS = 2.5  # of a topic that is slower than the control cycle


def fresh_for_s() -> dict[str, float]:
    """Seconds by topic of the stream. What comes once a cycle is late when the link is."""
    fresh = {
        f"tlm/{topic.name}": STALE_AFTER_S if topic.rate_hz is None else PATIENCE_PERIODS / topic.rate_hz
        for topic in TOPICS.values()
    }
    return fresh | {STATUS: PATIENCE_PERIODS * STATUS_PERIOD_S, ALARMS: 1e9}  # alarms come when they change
