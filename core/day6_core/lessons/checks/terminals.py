"""Checks of terminals and windows: what was run, what runs, what is open."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.lessons.actions import WINDOWS
from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.patterns import readable
from day6_core.lessons.texts import TEXTS, Say
from day6_core.session.plain import plain

if TYPE_CHECKING:
    from day6_core.lessons.live import Live
    from day6_core.shell.runs import Run


def plain_output(run: Run) -> str:
    """What a line printed, without control sequences."""
    return plain(run.output)


def single_blanks(line: str) -> str:
    """A line as `ran` and `running` compare it."""
    return " ".join(line.split())


@check("ran", event=True, patterns=("line", "prints"), one_of={"since": ("lesson", "step")})
def ran(
    live: Live, line: str, status: int | None = None, prints: str = "", since: str = "lesson", new: bool = False
) -> Verdict:
    wanted = Say("ran" if line.startswith("^") else "ran.with", line=readable(line))
    if status is not None:
        wanted = Say("ran.status", inner=wanted) if status == 0 else Say("ran.status_is", inner=wanted, status=status)
    if prints:
        wanted = Say("ran.prints", inner=wanted, prints=readable(prints))
    if new:
        wanted = Say("ran.new", inner=wanted)
    began = live.step_began_ns if since == "step" else live.lesson_began_ns
    runs = live.runs(began, new=new)
    saw = Say("ran.saw_nothing_new" if new else "ran.saw_nothing")
    if runs and runs[-1].began_ns >= began:  # what still runs from before is not the last command
        saw = Say("ran.saw_last", line=single_blanks(runs[-1].source))
    for run in reversed(runs):
        if not re.search(line, single_blanks(run.source)):
            continue
        right_status = status is None or run.status == status
        right_output = not prints or re.search(prints, plain_output(run)) is not None
        if right_status and right_output:
            return Verdict(True, wanted)
        if run.status is None and not right_status:
            saw = Say("ran.saw_running")
        elif not right_status:
            saw = Say("ran.saw_status", status=run.status)
        else:
            saw = Say("ran.saw_prints")
        break
    return Verdict(False, wanted, saw)


@check("running", patterns=("line",))
def running(live: Live, line: str) -> Verdict:
    lines = live.running()
    ok = any(re.search(line, each) for each in lines)
    return Verdict(ok, Say("running", line=readable(line)), None if ok else Say("running.saw", lines=tuple(lines)))


@check("terminals")
def terminals(live: Live, count: int) -> Verdict:
    found = len(live.terminals)
    return Verdict(
        found >= count, Say("terminals", count=count), Say("terminals.saw", found=found) if found < count else None
    )


@check("window", one_of={"kind": WINDOWS})
def window(live: Live, kind: str) -> Verdict:
    ok = bool(live.windows(kind))
    kinds = dict.fromkeys(each.kind for each in live.windows() if each.kind != "lesson")
    names = tuple(_title(each) for each in kinds)
    return Verdict(ok, Say("window", kind=_title(kind)), None if ok else Say("window.saw", kinds=names))


def _title(kind: str) -> Say | str:
    """What a window is called on the screen; one of a program of ROS is called as that is."""
    return Say(f"window.{kind}") if f"window.{kind}" in TEXTS else kind


@check("environment", patterns=("value",))
def environment(live: Live, name: str, value: str = ".") -> Verdict:
    values = [variables[name] for variables in live.variables() if name in variables]
    ok = any(re.search(value, each) for each in values)
    saw = None if ok else Say("environment.saw", name=name, values=tuple(dict.fromkeys(values)))
    return Verdict(ok, Say("environment", name=name, value=readable(value)), saw)


@check("sourced")
def sourced(live: Live, name: str) -> Verdict:
    for variables in live.variables():
        for prefix in variables.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
            if prefix and (Path(prefix) / "share" / name / "package.xml").is_file():
                return Verdict(True, Say("sourced", name=name))
    return Verdict(False, Say("sourced", name=name), Say("sourced.saw"))
