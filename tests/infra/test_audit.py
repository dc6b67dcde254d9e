"""What `make audit` says: weaknesses are told, and so is what could not be asked."""

import json

from tests.infra.audit import read_npm, read_pip


def test_a_known_weakness_is_told_with_what_mends_it() -> None:
    """Protects: a weakness never looks like a clean answer."""
    flaw = {"id": "PYSEC-1", "fix_versions": ["2.0"]}
    told = {"dependencies": [{"name": "a", "version": "1.0", "vulns": [flaw]}, {"name": "b", "version": "1"}]}
    found = read_pip("x.lock", json.dumps(told))
    assert (found.asked, found.weak, found.unasked) == (2, ["a 1.0: PYSEC-1, mended in 2.0"], "")
    flaws = {"c": {"severity": "high", "range": "<3"}}
    npm = read_npm("web", json.dumps({"metadata": {"dependencies": {"total": 7}}, "vulnerabilities": flaws}))
    assert (npm.asked, npm.weak) == (7, ["c: high, <3"])


def test_what_could_not_be_asked_is_not_clean() -> None:
    """Protects: without a network, or about packages that nobody knows, nothing is vouched for."""
    skipped = {"dependencies": [{"name": "a", "skip_reason": "not found"}]}
    for found in (
        read_pip("x.lock", json.dumps(skipped)),
        read_pip("x.lock", ""),
        read_npm("web", '{"message": "405"}'),
        read_npm("web", ""),
    ):
        assert found.asked == 0 and "NOT AUDITED" in found.line()
