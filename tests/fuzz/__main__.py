"""`python -m tests.fuzz [--cases 10000] [--start SEED]`: as every role; exit code 1 with any fault."""

import argparse
import logging
import tempfile
from pathlib import Path

from bumpless_server.access.who import Role
from tests.fuzz.fuzz import fuzz
from tests.fuzz.served import fuzzed


def main() -> int:
    """Print what came of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=10_000, help="of each role")
    parser.add_argument("--start", type=int, default=0, help="seed of the first operation")
    parser.add_argument("--role", choices=[role.name for role in Role], action="append")
    given = parser.parse_args()
    logging.disable(logging.CRITICAL)
    faults = 0
    with tempfile.TemporaryDirectory() as folder, fuzzed(Path(folder)) as served:
        for role in Role:
            if given.role and role.name not in given.role:
                continue
            tally = fuzz(
                served.running.url,
                served.document,
                role,
                served.tokens[role],
                served.known,
                given.cases,
                given.start,
            )
            print("\n".join(tally.lines()), flush=True)
            faults += sum(tally.faults.values())
    return int(faults > 0)


if __name__ == "__main__":
    raise SystemExit(main())
