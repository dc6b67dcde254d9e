"""The fast tests stay what they say they are."""

from tests.slow import ROOT, SLOW


def test_what_is_named_slow_exists() -> None:
    """Protects: a slow test that is moved or renamed does not slip into `make test-fast`."""
    assert [place for place in SLOW if not (ROOT / place).exists()] == []
