"""Plays the recorded cases and prints how many are equal: `python tests/conformance/score.py [WORD…]` (words in case names)."""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from day6_tui.core.ros import environment

environment.activate()

from golden_cases import GOLDEN, load_cases, load_exceptions  # noqa: E402
from machine import Machine  # noqa: E402


def main(words: list[str]) -> int:
    cases = [case for case in load_cases() if not words or any(word in case.name for word in words)]
    if not cases:
        print("no cases: the golden data is not beside the repository, or no case has such a name")
        return 1
    exceptions = load_exceptions()
    equal: Counter[str] = Counter()
    total: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        files = Path(folder) / "files"
        shutil.copytree(GOLDEN / "files", files)
        machine = Machine(GOLDEN / "nodes", files)
        for case in cases:
            group = " ".join(case.argv[1:3])
            total[group] += 1
            if any(not (GOLDEN / "nodes" / f"{node}.py").exists() for node in case.nodes if "ros2 run" not in node):
                print(f"-- {case.name}: no stand-in for {case.nodes}")
                continue
            found = machine.play(case)
            if not found:
                equal[group] += 1
                if case.name in exceptions:
                    print(f"== {case.name}: listed as an exception, but equal")
            elif case.name not in exceptions or words:
                print(f"== {case.name}: {' '.join(case.argv)}\n{found}\n")
        machine.close()
    for group in sorted(total):
        print(f"{equal[group]:4}/{total[group]:<4} {group}")
    print(f"{sum(equal.values())} of {sum(total.values())} equal")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
