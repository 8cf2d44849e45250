"""Plays healthy programs of strangers' public repositories and prints what the inspector says of each.

    python -m tests.inspector.strangers_table --sources FOLDER [--most 30] [--each 3] [WORD…]

FOLDER has checkouts of the repositories in `tests/conformance/strangers.json`. Each program runs alone, as its repository has
it, on a machine of its own. It is healthy if it is still running, and no traceback has come, when the inspector has looked some
times; others are counted and left out. Then every warning and every error is a false alarm, but for those in `TRUE`: that a
partner is not there, since the program runs alone.
"""

from __future__ import annotations

import argparse
import json
import shlex
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests.inspector.table import machine  # it also says where the rest is

# isort: split
from tests.conformance.checkouts import Missing, extract
from tests.conformance.strangers import INPUTS, Program, programs
from tests.inspector.lab import Lab

TRUE = frozenset(
    {"no_server", "service_near", "program_waits_service", "program_waits_action", "waits_in_callback", "no_clock"}
)
LOOKS = 12
"""Looks without an alarm: six seconds, more than any rule needs."""


def chosen(sources: Path, each: int, words: list[str]) -> Iterator[Program]:
    """Yield some programs of every repository that is there."""
    for entry in json.loads(INPUTS.read_text(encoding="utf-8"))["repositories"]:
        with tempfile.TemporaryDirectory(prefix="d6-") as place:
            try:
                tree = extract(entry["repository"], entry["commit"], sources, Path(place))
            except Missing:
                continue
            found = [program for program in programs(entry["repository"], tree)[0] if program.guarded]
            if words:
                yield from (program for program in found if any(word in program.name for word in words))
            else:
                yield from found[:: max(1, len(found) // each)][:each]


def play(lab: Lab, program: Program) -> dict[str, str] | None:
    """Return the alarms for a program, None if it is not healthy."""
    file = program.folder / Path(*program.module.split(".")).with_suffix(".py")
    lab.run(f"export PYTHONPATH={shlex.quote(str(program.folder))}:$PYTHONPATH")
    lab.start(f"python3 {shlex.quote(str(file))}")
    runs = lab.terminal().runs
    lab.wait(
        lambda: (
            lab._update()
            or runs.all[-1].status is not None
            or any(not node.name.startswith("_") for node in lab.desk.graph.nodes)
        )
    )
    said = lab.stays_silent(LOOKS)
    line = runs.all[-1]
    return None if line.status is not None or "Traceback (most recent" in line.output else said


def main() -> int:
    """Play them; the exit status is 1 if there was a false alarm."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--sources", type=Path, required=True)
    parser.add_argument("--most", type=int, default=30)
    parser.add_argument("--each", type=int, default=3)
    parser.add_argument("words", nargs="*", metavar="WORD")
    arguments = parser.parse_args()
    count: Counter[str] = Counter()
    for program in chosen(arguments.sources, arguments.each, arguments.words):
        with machine() as lab:
            said = play(lab, program)
        if said is None:
            count["left out"] += 1
            print(f"{program.name:90} left out", flush=True)
            continue
        wrong = {key: text for key, text in said.items() if key not in TRUE}
        count["healthy"] += 1
        count["alarms"] += len(wrong)
        print(f"{program.name:90} {', '.join(wrong) or '-'}", flush=True)
        for text in wrong.values():
            print(f"    {text}")
        if count["healthy"] == arguments.most:
            break
    print(
        f"\n{count['healthy']} healthy programs, {count['alarms']} false alarms; {count['left out']} were not healthy alone"
    )
    return int(count["alarms"] > 0)


if __name__ == "__main__":
    sys.exit(main())
