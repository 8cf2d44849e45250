"""What the corpus's programs printed, written down (`recorded_outputs.json`): their judgement needs no process then.

`python -m tests.advice.recorded_outputs` plays them and writes it anew; to be run by hand, after programs of the corpus have
changed. It has those that are started by one `python3 FILE` alone: what is told of them depends on nothing but their files.
"""

from __future__ import annotations

import json
import sys
import sysconfig
from pathlib import Path

import day6_core
from day6_core.advice.below import first_line_below
from day6_core.advice.explain import explain, scene_of
from day6_core.advice.matching import cards_in
from day6_core.advice.rules import Surroundings, hint_about_silence, hint_below
from day6_core.session.plain import without_sequences
from tests.advice.corpus import HINT, Mistake, Told, mistakes, play

RECORDED = Path(__file__).with_suffix(".json")
_PLACES = {"CORE": str(Path(day6_core.__file__).parents[1]), "STDLIB": sysconfig.get_path("stdlib")}
"""Beginnings of paths, which are others where the package is installed."""


def recordable() -> list[Mistake]:
    """Return the mistakes whose output is recorded."""
    return [
        each
        for each in mistakes()
        if not each.silent and [line for _, line, shows in each.typed if shows is None] == [f"python3 {_program(each)}"]
    ]


def _program(mistake: Mistake) -> str:
    return mistake.typed[0].line.removeprefix("python3 ") if len(mistake.typed) == 1 else ""


def outputs() -> dict[str, str]:
    """Return what was written down, by mistake."""
    found: dict[str, str] = json.loads(RECORDED.read_text(encoding="utf-8"))
    return found


def told_again(mistake: Mistake, output: str, home: Path, variables: dict[str, str]) -> list[Told]:
    """Write the files below `home`; return what is told of an output in a terminal with these variables."""
    (home / "ros2_ws" / "src").mkdir(parents=True)  # as every new home has it
    for name, text in mistake.files.items():
        path = home / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    for name, place in (_PLACES | {"HOME": str(home)}).items():
        output = output.replace(f"<{name}>", place)
    around = Surroundings({**variables, "HOME": str(home)}, home)
    command = mistake.typed[0].line
    if output.isspace():
        below = hint_about_silence(Path(_program(mistake)), around)
    else:
        below = hint_below(output, around) or first_line_below(output, around, command=command)
    match = next(cards_in(output), None)
    if below or match is None:
        return [Told(text, match.card.id if match is not None else "") for text in HINT.findall(below)]
    shown = explain(match, scene_of(match, around, output=output, command=command), "en")
    return [Told(f"{shown.means} {shown.here}", match.card.id)]


def _output(mistake: Mistake) -> str:
    """Play one; return what its program printed, without our own lines and without the places of this machine."""
    from tests.inspector.table import machine  # it also sets what a process of a test is given

    with machine() as lab:
        play(lab, mistake.files, mistake.typed, "en")
        printed = without_sequences(lab.terminals[0].runs.all[0].output).replace("\r", "")
        for name, place in (_PLACES | {"HOME": str(lab.home)}).items():
            printed = printed.replace(place, f"<{name}>")
    return HINT.sub("", printed).rstrip("\n") + "\n"


def main() -> int:
    found = {each.id: _output(each) for each in recordable()}
    RECORDED.write_text(json.dumps(found, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
