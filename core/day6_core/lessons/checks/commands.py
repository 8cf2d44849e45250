"""Checks of the commands that were really run, each with its own status and output, in whatever line they stood."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from fnmatch import fnmatchcase
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.patterns import readable
from day6_core.lessons.texts import Say
from day6_core.places import as_on_linux
from day6_core.session.plain import plain

if TYPE_CHECKING:
    from pathlib import Path

    from day6_core.lessons.live import Live
    from day6_core.shell.runs import Ran

SIGPIPE = 141
"""The status of a command whose reader has read enough (`| head`): it did nothing wrong."""

_SAY_THEIR_WORDS = ("echo", "printf", "bash", "sh")
"""Commands that print what was typed: it tells nothing unless an expansion has put it there."""

_SYSTEM = ("/bin/", "/usr/bin/", "/opt/ros/")
_TYPE = re.compile(r"(\w+)/(msg|srv|action)/(\w+)")


class Found(NamedTuple):
    """Whether a command did what is wanted; else `wrong` says what the last one didn't do, None if it was never run."""

    ok: bool
    wrong: Say | None = None


@check("command", event=True, patterns=("prints",), one_of={"since": ("lesson", "step")})
def command(
    live: Live,
    words: str,
    status: int | None = None,
    prints: str = "",
    part: bool = False,
    uses: str = "",
    since: str = "lesson",
    new: bool = False,
) -> Verdict:
    began = live.began_ns(since)
    commands = live.commands(began, new=new)
    meant = [ran for ran in commands if is_meant(words, ran, live.home) and (not uses or _uses(uses, ran))]
    found = as_wanted(meant, commands, status, prints, part=part)
    wanted = told(Say("ran", line=f"{example(words)} ${uses}" if uses else example(words)), status, prints, new=new)
    wanted = Say("ran.part", inner=wanted) if part else wanted
    return Verdict(found.ok, wanted, None if found.ok else found.wrong or last_line(live, began, new=new))


@check("runs")
def runs(live: Live, words: str) -> Verdict:
    ok = any(is_meant(words, ran, live.home) for ran in live.unfinished())
    saw = None if ok else Say("running.saw", lines=tuple(live.running()))
    return Verdict(ok, Say("running", line=example(words)), saw)


@check("visited", event=True, paths=("path", "back"), one_of={"since": ("lesson", "step")})
def visited(live: Live, path: str, back: str = "", since: str = "lesson") -> Verdict:
    began = live.began_ns(since)
    wanted = Say("visited.back", path=path, back=back) if back else Say("visited", path=path)
    there, home = live.path(path).resolve(), live.path(back or path).resolve()
    for places in live.places(began):
        resolved = [place.resolve() for place, _ in groupby(places)]  # most commands run where the last one did
        if there in resolved and home in resolved[resolved.index(there) :]:
            return Verdict(True, wanted)
    return Verdict(False, wanted, last_line(live, began, new=False))


# -- which command is meant ------------------------------------------------------------------------------------------------


def program_of(ran: Ran) -> str:
    """The name of the program: a command of the system or of ROS is called by its name or by its path."""
    name = ran.argv[0]
    return os.path.basename(name) if name.startswith(_SYSTEM) else name


def is_meant(words: str, ran: Ran, home: Path) -> bool:
    """Whether it is the command that a lesson means by `words`: see writing/en.md. `--help` is never meant."""
    if ran.is_function:
        return False
    wanted, given = words.split(), [program_of(ran), *ran.argv[1:]]
    if "--help" in given or ("-h" in given and given[0] in ("ros2", "colcon")):
        return False
    at = 0
    for number, word in enumerate(given):
        if at == len(wanted):
            break
        if any(_is_same(each, word, ran, home) for each in wanted[at].split("|")):
            at += 1
        elif not number or not (word.startswith("-") or given[number - 1].startswith("-")):
            return False  # neither an option nor the value of one
    return 0 < at == len(wanted)


def _is_same(wanted: str, given: str, ran: Ran, home: Path) -> bool:
    if wanted.startswith("~"):
        return os.path.realpath(ran.cwd / given) == os.path.realpath(f"{home}{wanted[1:]}")
    if wanted.startswith("/") and as_on_linux(Path(os.path.normpath(ran.cwd / given))) == wanted:
        return True
    if wanted.startswith("/") and not given.startswith("/"):
        given = f"/{given}"  # a name of the graph, relative to the namespace /
    return fnmatchcase(given, wanted) or (bool(_TYPE.fullmatch(wanted)) and _TYPE.sub(r"\1/\3", wanted) == given)


def _uses(variable: str, ran: Ran) -> bool:
    return re.search(rf"\$\{{?[!#]?{re.escape(variable)}\b", ran.source) is not None


def example(words: str) -> str:
    """What a pupil reads of it: the first of each word's alternatives."""
    return " ".join(word.split("|")[0].rstrip("*") for word in words.split())


# -- what it did -----------------------------------------------------------------------------------------------------------


def as_wanted(
    meant: Sequence[Ran], commands: Sequence[Ran], status: int | None, prints: str, *, part: bool = False
) -> Found:
    """Whether one of those that are meant ended with this status and showed this; else what is wrong with the last one."""
    wrong: Say | None = None
    for ran in reversed(meant):
        right_status = status is None or ran.status == status or (status == 0 and ran.status == SIGPIPE)
        if right_status and (not prints or is_shown(prints, ran, commands, part=part)):
            return Found(True)
        if wrong is not None:
            continue
        if right_status and part:
            return Found(False)  # what was run last tells more
        if right_status:
            wrong = Say("ran.saw_prints")
        else:
            wrong = how_it_ended(ran.status)
    return Found(False, wrong)


def is_shown(pattern: str, ran: Ran, commands: Iterable[Ran], *, part: bool = False) -> bool:
    """Whether it printed something like that where it could be read: on the screen, or by way of another command.

    `part`: only by way of one that showed fewer lines.
    """
    found = re.search(pattern, _read(ran.screen))
    if found is not None and not part and not _says_its_words(ran, found[0]):
        return True
    elsewhere = _read(ran.elsewhere)
    found = re.search(pattern, elsewhere)
    if found is None or _says_its_words(ran, found[0]):
        return False
    text, lines = found[0].strip(), elsewhere.count("\n")
    return any(
        text in (screen := _read(each.screen))
        and not _says_its_words(each, text)
        and (not part or screen.count("\n") < lines)
        for each in commands
        if each.began_ns >= ran.began_ns and each is not ran
    )


def _read(text: str) -> str:
    """What stood there, with the slashes that patterns have in paths."""
    return plain(text).replace(os.sep, "/")


def _says_its_words(ran: Ran, text: str) -> bool:
    return program_of(ran) in _SAY_THEIR_WORDS and text.strip() in ran.source


# -- what is told ----------------------------------------------------------------------------------------------------------


def how_it_ended(status: int | None) -> Say:
    """What is told of a command that did not end as wanted."""
    return Say("ran.saw_running") if status is None else Say("ran.saw_status", status=status)


def told(command: Say, status: int | None, prints: str, *, new: bool) -> Say:
    """What is wanted of a command, in a sentence."""
    if status is not None:
        command = (
            Say("ran.status", inner=command) if status == 0 else Say("ran.status_is", inner=command, status=status)
        )
    if prints:
        command = Say("ran.prints", inner=command, prints=readable(prints))
    return Say("ran.new", inner=command) if new else command


def last_line(live: Live, began_ns: int, *, new: bool) -> Say:
    """What was run last, if it was not what is wanted."""
    lines = live.runs(began_ns, new=new)
    if lines and lines[-1].began_ns >= began_ns:  # what still runs from before is not the last command
        return Say("ran.saw_last", line=single_blanks(lines[-1].source))
    return Say("ran.saw_nothing_new" if new else "ran.saw_nothing")


def single_blanks(line: str) -> str:
    """A line as it is compared and shown."""
    return " ".join(line.split())
