"""Prints the table of the faults inside programs: `python -m tests.inspector.inner_table [WORD…]` plays each for real.

A WORD chooses drills by number or a part of the name. A drill is found if one of its findings comes within five seconds of its
symptom; what else is said as a warning or an error beside it is listed.
"""

from __future__ import annotations

import sys
import time

from tests.inspector.table import machine  # it also says where the rest is

# isort: split
from tests.inspector.inner_drills import INNER_DRILLS

WITHIN = 5.0
"""Seconds after a symptom in which it has to be named."""


def main(words: list[str]) -> int:
    """Play them; the exit status is 1 if less than 95 % are found in time."""
    began = time.monotonic()
    drills = [
        each for each in INNER_DRILLS if not words or any(word == each.number or word in each.name for word in words)
    ]
    found_count = 0
    print(f"{'no.':5}{'drill':48}{'found':24}{'s':>5}  beside it")
    for drill in drills:
        with machine() as lab:
            drill.inject(lab)
            found, seconds = lab.finds(*drill.findings)
            others = [key for key, each in lab.findings.items() if each.level != "info" and key not in drill.findings]
            key = found.id.removeprefix("inspector.") if found is not None else "NOT FOUND"
            found_count += found is not None and seconds < WITHIN
            print(f"{drill.number:5}{drill.name:48}{key:24}{seconds:5.1f}  {', '.join(others)}", flush=True)
            if words:
                print("    ", found.text if found is not None else lab.screen())
    print(f"\n{found_count} of {len(drills)} found within {WITHIN:g} s; {time.monotonic() - began:.0f} s")
    return int(found_count < 0.95 * len(drills))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
