"""Writes `recorded.jsonl` anew: `python -m tests.inspector.record_facts [WORD…]` plays drills and healthy scenes for real.

With words only the cases whose names begin with one of them; the others stay as they are. To be run by hand, after the drills
or the facts have changed.
"""

from __future__ import annotations

import sys
import time
from typing import Any

from tests.inspector.table import machine  # it also says where the rest is

from tests.inspector.recording import RECORDED, Case, found_in, read_cases, recorded, write_cases  # isort: skip
from tests.inspector.scenes import ALL, Scene  # isort: skip
from tests.support.waiting import until  # isort: skip

AFTERWARDS = 2.0
"""Seconds that a machine goes on before its facts are taken: what had just begun is there then."""


def play(scene: Scene) -> Case:
    """Play one on a machine of its own and take its facts."""
    with machine() as lab:
        scene.happens(lab)

        def look() -> Case | None:
            for terminal in list(lab.desk.terminals):
                terminal.update()
            taken: list[Any] = []
            lab.desk.scheduler.call_soon_threadsafe(lambda: taken.append(lab.inspector.facts()))
            facts = until(lambda: taken)[0]
            found = [(level, key) for level, key, *_ in found_in(facts) if key != "inspector.late"]
            if scene.findings:
                is_right = bool({key for _, key in found} & set(scene.findings))
            else:
                is_right = all(level == "info" for level, _ in found)
            return recorded(scene.name, facts, lab.home) if is_right else None

        first = until(look, every=0.1)
        time.sleep(AFTERWARDS)
        return look() or first


def main() -> int:
    words = tuple(sys.argv[1:])
    cases = {case.name: case for case in (read_cases() if RECORDED.exists() else ())}
    for scene in ALL:
        if not words or scene.name.startswith(words):
            cases[scene.name] = play(scene)
            print(f"{scene.name}: {', '.join(each[1] for each in cases[scene.name].findings) or '-'}", flush=True)
            write_cases([cases[each.name] for each in ALL if each.name in cases])
    return 0


if __name__ == "__main__":
    sys.exit(main())
