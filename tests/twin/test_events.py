"""Events of a simulated run: the quick look at changed rows must miss none."""

from twin.events import EventWriter, eventful, row_events
from twin.records import SETTINGS
from twin.settings import fill_settings
from twin.simulation import Result, one


def test_rows_passed_over_have_nothing_to_say(flight: Result) -> None:
    """Protects: what `row_events` learns to tell and `eventful` does not look for is lost in batches."""
    settings = one(SETTINGS)
    fill_settings(settings, flight.vehicle, flight.parameters)
    chosen = set(eventful(flight.log))
    told = set()
    for k in range(1, len(flight.log)):
        writer = EventWriter()
        row_events(writer, flight.log[k - 1], flight.log[k], settings[0])
        if writer.drain():
            told.add(k)
    assert told and told <= chosen
