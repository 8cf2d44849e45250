"""Prints the inspector's table: `python -m tests.inspector.table` plays every drill and every healthy scene.

With words only what begins with one of them: `d` for the faults in messages, `i` for those inside programs, `d4` for some of
them; then what was said is printed, too, or the screen where nothing was. Each has a machine of its own. A drill is found if one
of its findings comes within five seconds of its symptom. What else is said as a warning or an error beside it is listed: it may
be another face of the same fault. In a healthy scene every warning and every error is a false alarm.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tests import conftest as surroundings

# isort: split
from tests.inspector.lab import Lab
from tests.inspector.scenes import INJECTED
from tests.inspector.test_healthy import SCENES

WITHIN = 5.0
"""Seconds after a symptom in which it has to be named."""


@contextmanager
def machine() -> Iterator[Lab]:
    """A lab in an empty folder."""
    with tempfile.TemporaryDirectory(prefix="d6-", ignore_cleanup_errors=True) as folder:
        surroundings.set_environment(
            {**surroundings.environment(), "DAY6_RUNTIME_DIR": f"{folder}/r", "DAY6_LINK": "on"}
        )
        lab = Lab(Path(folder, "home"))
        try:
            yield lab
        finally:
            lab.close()


def main() -> int:
    """Play everything; the exit status is 1 if less than 95 % are found or a healthy scene gives an alarm."""
    began = time.monotonic()
    found_count = alarms = 0
    words = tuple(sys.argv[1:])
    drills = [drill for drill in INJECTED if not words or drill.number.startswith(words)]
    scenes = [scene for scene in SCENES if not words or scene.__name__.startswith(words)]
    print(f"{'no.':5}{'drill':56}{'found':28}{'s':>5}  beside it")
    for drill in drills:
        with machine() as lab:
            drill.inject(lab)
            found, seconds = lab.finds(*drill.findings)
            others = [key for key, each in lab.findings.items() if each.level != "info" and key not in drill.findings]
            said = found.id.removeprefix("inspector.") if found is not None else "NOT FOUND"
            found_count += found is not None and seconds < WITHIN
            print(f"{drill.number:5}{drill.name:56}{said:28}{seconds:5.1f}  {', '.join(others)}", flush=True)
            if words:
                print("    ", found.text if found is not None else lab.screen())
    print(f"\n{'healthy scene':61}false alarms")
    for scene in scenes:
        with machine() as lab:
            scene(lab)
            said_wrongly = lab.stays_silent()
            alarms += len(said_wrongly)
            print(f"{scene.__name__:61}{', '.join(said_wrongly) or '-'}", flush=True)
    took = time.monotonic() - began
    print(f"\n{found_count} of {len(drills)} drills found, {alarms} false alarms in {len(scenes)} scenes; {took:.0f} s")
    return int(found_count < 0.95 * len(drills) or alarms > 0)


if __name__ == "__main__":
    sys.exit(main())
