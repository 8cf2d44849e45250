"""Ways through every step of the shipped lessons, right ones and cheats: what was recorded of it, told otherwise.

`python -m tests.lessons.ways` prints how many right ways count and how many cheats are refused, for every step and drill, with
those of `typed_ways.yaml`, typed in the real shell. `--played` then plays those of `other_ways.yaml`, with processes.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from tests import conftest as surroundings

# isort: split
from day6_core.lessons.checks import Condition
from day6_core.lessons.document import Step
from day6_core.lessons.reading import read_lesson
from day6_core.shell.commands import place_of
from tests.lessons.histories import SHIPPED, judged, read_histories
from tests.support.recorded_live import HOME, Json

ABOUT_COMMANDS = frozenset({"command", "runs", "visited"})
NO_STATE = ABOUT_COMMANDS | {"answer", "terminals"}
"""Checks of what the recorded terminals and answers tell."""

Change = Callable[[Json], list[Json]]
"""What is made of one command of a recorded line, the way `RecordingLive` wrote it down."""


class Told(NamedTuple):
    """One way, and whether it solves the step."""

    name: str
    is_right: bool
    is_solved: bool

    @property
    def is_as_it_should(self) -> bool:
        return self.is_right == self.is_solved


# -- the ways --------------------------------------------------------------------------------------------------------------


def _by_path(ran: Json) -> list[Json]:
    argv = ran[0]
    return [[[place_of(argv[0]) or argv[0], *argv[1:]], *ran[1:]]]


def _through_a_pipe(ran: Json) -> list[Json]:
    argv, source, cwd, began, ended, status, is_function, screen, elsewhere = ran
    cat = [["cat"], "cat", cwd, began, ended, status, False, screen, ""]
    return [[argv, source, cwd, began, ended, status, is_function, "", elsewhere + screen], cat]


def _in_a_script(ran: Json) -> list[Json]:
    return [[["bash", "by_hand.sh"], "bash by_hand.sh", *ran[2:]], ran]


def _echoed(ran: Json) -> list[Json]:
    said = " ".join([*ran[0], ran[7], ran[8]])
    return [[["echo", said], f"echo '{said}'", HOME, ran[3], ran[3], 0, False, said, ""]]


def _in_a_comment(ran: Json) -> list[Json]:
    name = "sleep" if ran[4] is None else "true"
    return [[[name, "1000"], f"{name} 1000", HOME, *ran[3:6], False, "", ""]]


def _by_a_function(ran: Json) -> list[Json]:
    return [[*ran[:2], HOME, *ran[3:6], True, "", ""], *_echoed(ran)]


def _for_help(ran: Json) -> list[Json]:
    return [[[*ran[0], "--help"], f"{ran[1]} --help", HOME, *ran[3:]]]


def _thrown_away(ran: Json) -> list[Json]:
    return [[*ran[:2], HOME, *ran[3:7], "", ""]]


RIGHT: Mapping[str, Change] = {
    "by its whole path": _by_path,
    "through a pipe": _through_a_pipe,
    "in a script": _in_a_script,
}
CHEATS: Mapping[str, Change] = {
    "echoed, with what it prints": _echoed,
    "in a comment": _in_a_comment,
    "a function of that name": _by_a_function,
    "with --help": _for_help,
}


def changed(moment: Json, change: Change) -> Json:
    """The moment with every command of every line told otherwise."""
    if "terminals" not in moment:
        return moment
    terminals = [
        {
            **terminal,
            "cwd": terminal.get("cwd", HOME) if change in RIGHT.values() else HOME,
            "runs": [
                [*run[:6], [each for ran in run[6] for each in change(ran)]] for run in terminal["runs"] if run[6:]
            ],
        }
        for terminal in moment["terminals"]
    ]
    return {**moment, "terminals": terminals}


def ways_of(step: Step, moments: list[Json], folder: Path) -> list[Told]:
    """All ways for a step of which this was recorded."""
    began = max(at for at, moment in enumerate(moments) if "began" in moment)
    last, first = moments[began:], moments[0]
    names = {name for check in step.checks for name in _names(check)}
    found = []

    def tell(name: str, told: list[Json], *, right: bool, asked: Step = step) -> None:
        solved = all(verdict[0] for verdict in judged(asked, told, folder)[-1])
        found.append(Told(name, right, solved))

    if names & ABOUT_COMMANDS:  # the other checks hold in all of these: they don't look at commands
        asked = replace(step, checks=tuple(check for check in step.checks if _names(check) & ABOUT_COMMANDS))
        short = [{key: moment[key] for key in moment.keys() - {"heard", "files"}} for moment in last]
        for name, change in (*RIGHT.items(), *CHEATS.items()):
            tell(name, [changed(moment, change) for moment in short], right=name in RIGHT, asked=asked)
    else:
        for name, change in {**RIGHT, "without any command": lambda ran: []}.items():
            tell(name, [changed(moment, change) for moment in last], right=True)
    if _begins_without(step, first):
        end = last[-1]
        kept = {key: end[key] for key in ("at", "answer", "terminals") if key in end}
        as_before = {**first, **kept, "began": last[0]["began"]}
        as_before["terminals"] = [{**each, "variables": {}} for each in kept.get("terminals", ())]
        for name, change in {"typed, and nothing came of it": lambda ran: [ran], **CHEATS}.items():
            tell(f"nothing came of it: {name}", [changed(as_before, change)], right=False)
    verdicts = judged(step, moments, folder)
    for number in range(1, len(step.wrong) + 1):
        ends = [each for moment, each in zip(moments, verdicts, strict=True) if moment["part"] == f"wrong {number}"]
        found.append(Told(f"the file's wrong answer {number}", False, all(verdict[0] for verdict in ends[-1])))
    if "answer" in last[-1]:
        for letter in "abcd".replace(last[-1]["answer"], ""):
            told = [{**moment, "answer": letter} if "answer" in moment else moment for moment in last]
            tell(f"answered {letter}", told, right=False)
    return found


def _names(check: Condition) -> set[str]:
    return {each.name for each in check.every() if not each.parts}


def _begins_without(step: Step, first: Json) -> bool:
    """Whether some state that the step wants is not there before it."""
    return any(
        not verdict[0]
        for check, verdict in zip(step.checks, first["verdicts"], strict=True)
        if not _names(check) & NO_STATE
    )


def every_way() -> dict[str, list[Told]]:
    """The ways of every step that ships, by `file/step`."""
    steps = {(path.name, step.name): (step, path.parent) for path in SHIPPED for step in read_lesson(path).steps}
    found = {}
    for history in read_histories():
        for told in history["steps"]:
            step, folder = steps[history["file"], told["step"]]
            found[f"{history['file'].removesuffix('.md')}/{step.name}"] = ways_of(step, told["moments"], folder)
    return found


# -- the table -------------------------------------------------------------------------------------------------------------


def main() -> int:
    import tempfile
    import time

    import pytest

    from tests.lessons import test_typed_ways as typed

    surroundings.set_environment(surroundings.environment())
    total, found = Counter[tuple[bool, bool]](), every_way()
    for where, ways in found.items():
        file, _, name = where.partition("/")
        key = next((each for each in typed.WAYS if each in (where, f"{file[:2]}/{name}")), None)
        if key is not None:
            with tempfile.TemporaryDirectory(prefix="d6-") as home:
                counted = typed.played(key, Path(home), lambda: time.sleep(0.01))
            ways += [Told(way, way in typed.WAYS[key]["right"], counts) for way, counts in counted.items()]
        count = Counter((each.is_right, each.is_as_it_should) for each in ways)
        total += count
        print(f"{where:40} {_row(count)}", *(f"\n    {each}" for each in ways if not each.is_as_it_should), flush=True)
    print(f"{f'{len(found)} steps and drills':40} {_row(total)}")
    if "--played" in sys.argv:
        return int(pytest.main(["-q", "-m", "", str(Path(__file__).with_name("test_other_ways.py"))]))
    return int(any(not fine for _, fine in total))


def _row(count: Counter[tuple[bool, bool]]) -> str:
    fine = {right: f"{count[right, True]:4} of {count[right, True] + count[right, False]:4}" for right in (True, False)}
    return f"counted {fine[True]}   refused {fine[False]}"


if __name__ == "__main__":
    sys.exit(main())
