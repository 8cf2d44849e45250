"""Checks of terminals and windows: what was run, what runs, what is open."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

from day6_tui.core.lessons.checks import Verdict, check
from day6_tui.core.lessons.texts import Say

if TYPE_CHECKING:
    from day6_tui.core.lessons.live import Live
    from day6_tui.core.shell.runs import Run

_CODES = re.compile(r"\x1b\[[0-9;:?]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)|[\x00-\x08\x0b-\x1f\x7f]")
_PLAIN = re.compile(r"[\w /.~:-]+\Z")
"""A pattern that means itself, nearly: it can be shown as the command."""


def plain_output(run: Run) -> str:
    """What a line printed, without control sequences."""
    return _CODES.sub("", run.output.replace("\r\n", "\n"))


def single_blanks(line: str) -> str:
    """A line as `ran` and `running` compare it."""
    return " ".join(line.split())


@check("ran", event=True, patterns=("line", "prints"))
def ran(live: Live, line: str, status: int | None = None, prints: str = "", since: str = "lesson") -> Verdict:
    wanted = Say("ran" if _PLAIN.match(line) else "ran.pattern", line=readable(line))
    if status is not None:
        wanted = Say("ran.status", inner=wanted) if status == 0 else Say("ran.status_is", inner=wanted, status=status)
    if prints:
        wanted = Say("ran.prints", inner=wanted, prints=readable(prints))
    began = live.step_began_ns if since == "step" else live.lesson_began_ns
    runs = live.runs(began)
    saw = Say("ran.saw_nothing")
    if runs:
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


def readable(pattern: str) -> str:
    """A regular expression nearly as the text it stands for."""
    text = re.sub(r"\(\?[:=!<P][^)]*\)|^\(\?[aimsx]+\)", "…", pattern.strip("^$"))
    text = re.sub(r"\\([.\-/+*?()\[\]$^|])", r"\1", text)
    return re.sub(r"\\[bBsSwWdD][+*]?|\.[*+]\??", "…", text).strip("…") or pattern


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


@check("window")
def window(live: Live, kind: str) -> Verdict:
    ok = bool(live.windows(kind))
    kinds = tuple(dict.fromkeys(each.kind for each in live.windows() if each.kind != "lesson"))
    return Verdict(ok, Say("window", kind=kind), None if ok else Say("window.saw", kinds=kinds))


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
