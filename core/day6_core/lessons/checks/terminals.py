"""Checks of terminals and windows: what was run and runs, by patterns of lines; what is open."""

from __future__ import annotations

import os
import re
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.lessons.actions import WINDOWS
from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.commands import Found, as_wanted, how_it_ended, last_line, program_of, single_blanks, told
from day6_core.lessons.checks.patterns import readable
from day6_core.lessons.texts import TEXTS, Say
from day6_core.session.plain import plain
from day6_core.shell.language import parser
from day6_core.shell.language.words import SyntaxProblem

if TYPE_CHECKING:
    from day6_core.lessons.live import Live
    from day6_core.shell.runs import Ran, Run


def plain_output(run: Run) -> str:
    """What a line printed, without control sequences."""
    return plain(run.output)


@check("ran", event=True, patterns=("line", "prints"), one_of={"since": ("lesson", "step")})
def ran(
    live: Live, line: str, status: int | None = None, prints: str = "", since: str = "lesson", new: bool = False
) -> Verdict:
    began = live.began_ns(since)
    commands = live.commands(began, new=new)
    found = as_wanted([each for each in commands if is_like(line, each, prints)], commands, status, prints)
    if found.wrong is None and not found.ok:
        found = _by_whole_line(live, line, began, status, prints, new=new)
    wanted = told(Say("ran" if line.startswith("^") else "ran.with", line=readable(line)), status, prints, new=new)
    return Verdict(found.ok, wanted, None if found.ok else found.wrong or last_line(live, began, new=new))


def is_like(line: str, ran: Ran, prints: str = "") -> bool:
    """Whether a pattern matches a command as it was typed, or with its words expanded and its program's name alone.

    What `echo` is given to say is no command, unless the lesson wants to see it printed.
    """
    expanded = " ".join([program_of(ran), *ran.argv[1:]])
    find = re.match if not prints and program_of(ran) in _SAY_ANYTHING else re.search
    return not ran.is_function and any(find(line, single_blanks(each)) for each in (expanded, ran.source))


_SAY_ANYTHING = ("echo", "printf", "true", ":")
_JOINS = re.compile(r"[|;&\n]")


def _by_whole_line(live: Live, line: str, began_ns: int, status: int | None, prints: str, *, new: bool) -> Found:
    """The same for patterns that match several commands with what joins them (`ros2 pkg list | grep turtle`)."""
    found = Found(False)
    for run in reversed(live.runs(began_ns, new=new)):
        matched = re.search(line, single_blanks(_without_comments(run.source)))
        if matched is None or not _JOINS.search(matched[0]) or not run.commands:
            continue
        found = as_wanted(run.commands, run.commands, None, prints)
        if found.ok and status not in (None, run.status):
            found = Found(False, how_it_ended(run.status))
        if found.ok:
            break
    return found


@lru_cache(maxsize=256)
def _without_comments(source: str) -> str:
    try:
        return "; ".join(item.source for item in parser.parse(source).items)
    except SyntaxProblem:
        return ""


@check("running", patterns=("line",))
def running(live: Live, line: str) -> Verdict:
    ok = any(is_like(line, each) for each in live.unfinished())
    return Verdict(
        ok, Say("running", line=readable(line)), None if ok else Say("running.saw", lines=tuple(live.running()))
    )


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
