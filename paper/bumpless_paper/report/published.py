"""The numbers that Gao et al. 2026 print in their tables.

Source: Gao et al. 2026, J. Mar. Sci. Eng. 14(5) 516, doi:10.3390/jmse14050516 (CC BY 4.0), tables 1 to 8,
A5 and A6, as printed; Table 3's flat sets have no volume.
"""

import json
from functools import cache
from pathlib import Path
from typing import Any


@cache
def published() -> dict[str, Any]:
    """All tables by name."""
    return json.loads(Path(__file__).with_name("published.json").read_text(encoding="utf-8"))
