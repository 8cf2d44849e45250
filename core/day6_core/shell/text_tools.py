"""Which of the text tools are the machine's, and for which command lines ours stand in.

Ours are there for three reasons: machines without the real ones (Windows), files that only the simulated machine has, and speed:
a call of ours costs a tenth of a process. `TOOLS` says of each what it certainly does as GNU's tool does. A command line within
that is ours; any other one is the real tool's where the machine has it. Where it hasn't, ours does what it can and refuses
options that it doesn't know.

Whichever changes files asks before one outside the home folder is changed. What isn't in the table is ours alone (it shows the
simulated machine, or starts other commands: `cd`, `xargs`, `which` …) or the machine's alone (awk, stat, git, make …).
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from typing import NamedTuple

from day6_core.session.session import Main, Session
from day6_core.shell.outside import agreed, keys_of
from day6_core.shell.process.real_tools import find_tool

MACHINES = sys.platform != "win32"
"""Whether the machine's tools are looked for: the find and sort of Windows are others."""


class Ours(NamedTuple):
    """What ours obeys as GNU's tool does: letters, letters with a value, long options, and operands that are no files."""

    flags: str = ""
    values: str = ""
    long: tuple[str, ...] = ()
    once: str = ""
    """Of these letters, at most one in all."""
    fits: Callable[[list[str], list[str]], bool] | None = None
    """Says of the given letters and the operands whether ours does the rest of it exactly."""


def _simple_script(letters: list[str], operands: list[str]) -> bool:
    """One command of sed: a substitution without numbers and `p`, or lines printed or deleted by number."""
    script = operands[0] if operands else ""
    if re.fullmatch(r"s([/|#,])(?:(?!\1)[\w .:=\"<>@~%!;,/|#-])+\1(?:(?!\1)[\w .:=\"<>@~%!;,/|#-])*\1g?", script):
        return "n" not in letters
    return bool(re.fullmatch(r"(?:\d+|\$)(?:,(?:\d+|\$))?[pd]", script))


def _plain_search(letters: list[str], operands: list[str]) -> bool:
    """A pattern that means the same in every kind of regular expression, or -F."""
    return bool(operands) and (
        "F" in letters or re.fullmatch(r"\^?[\w /:,=@%#\"'<>~;!&-]+\$?", operands[0]) is not None
    )


def _plain_mode(letters: list[str], operands: list[str]) -> bool:
    return bool(operands) and re.fullmatch(r"[0-7]{3,4}|\+x", operands[0]) is not None


TOOLS: dict[str, Ours] = {
    "basename": Ours(fits=lambda letters, operands: len(operands) in (1, 2)),
    "chmod": Ours("R", long=("--recursive",), fits=_plain_mode),
    "cp": Ours("rRafvinpudP", long=("--recursive",)),
    "cut": Ours("s", "dfc"),
    "date": Ours("uRI"),
    "diff": Ours(fits=lambda letters, operands: False),
    "dirname": Ours(),
    "egrep": Ours("ivncwxoqlrHhs", "", ("--color", "--color=auto"), fits=_plain_search),
    "fgrep": Ours("ivncxqlrHhs", "", ("--color", "--color=auto")),
    "find": Ours(),
    "grep": Ours("ivncFEwxqlrHhs", "", ("--color", "--color=auto"), fits=_plain_search),
    "head": Ours("q", "n"),
    "ls": Ours("laAlhtrRS1Fdp", long=("--color", "--color=auto", "--all", "--almost-all", "--recursive")),
    "mkdir": Ours("p", "m", long=("--parents",)),
    "mv": Ours("fvinu"),
    "readlink": Ours("f"),
    "realpath": Ours(),
    "rev": Ours(),
    "sed": Ours("ni", "", ("--in-place",), fits=_simple_script),
    "rm": Ours("rRfvid", long=("--recursive", "--force")),
    "rmdir": Ours(),
    "seq": Ours(fits=lambda letters, operands: all(re.fullmatch(r"-?\d+(\.\d+)?", word) for word in operands)),
    "sort": Ours("rnu", "o", once="rnu"),
    "tail": Ours("qfF", "n"),
    "touch": Ours(),
    "tr": Ours("ds", fits=lambda letters, operands: len(operands) == (1 if letters == ["d"] else 2)),
    "uniq": Ours("cdu", once="cdu"),
    "wc": Ours("lwc"),
}
"""Name -> what ours does exactly."""

_CHANGING: dict[str, re.Pattern[str]] = {
    "find": re.compile(r"-delete|-exec(?:dir)?|-ok(?:dir)?|-fprint(?:f|0)?|-fls"),
    "sed": re.compile(r"-[nErsuz]*i.*|--in-place.*"),
    "sort": re.compile(r"-[a-zA-Z]*o.*|--output.*"),
    **dict.fromkeys(("chmod", "cp", "mkdir", "mv", "rm", "rmdir", "touch"), re.compile(r".*", re.DOTALL)),
}
"""Tool -> the words of a command line by which it changes files."""


_AT_ONCE = dict.fromkeys(("grep", "egrep", "fgrep"), ("--line-buffered",)) | {"sed": ("-u",)}
"""Options for those behind `ros2 topic echo |`: each line is wanted when it comes, and GNU's only do so on a terminal."""


def is_exactly_ours(argv: list[str]) -> bool:
    """Whether ours does what this command line says exactly as GNU's tool."""
    ours, letters, operands = TOOLS[argv[0]], list[str](), list[str]()
    waiting = argv[1:]
    while waiting:
        word = waiting.pop(0)
        if word == "--":
            operands += waiting
            break
        if word.startswith("--"):
            if word not in ours.long:
                return False
        elif word.startswith("-") and len(word) > 1:
            if word[1:].isdigit() and argv[0] in ("head", "tail"):
                continue
            for at, letter in enumerate(word[1:], 2):
                if letter in ours.values:
                    letters.append(letter)
                    if at == len(word):
                        del waiting[:1]
                    break
                if letter not in ours.flags:
                    return False
                letters.append(letter)
        else:
            operands.append(word)
    if len(letters) != len(set(letters)) or sum(letter in ours.once for letter in letters) > 1:
        return False
    return ours.fits is None or ours.fits(letters, operands)


def chosen(name: str, ours: Main) -> Main:
    """Return the program that is ours or the machine's, as the command line needs."""

    async def main(session: Session) -> int | None:
        suits = is_exactly_ours([name, *session.argv[1:]]) or _names_a_simulated_file(session)
        if suits or not (tool := _tool(name, session)):
            return await ours(session)
        if (changing := _CHANGING.get(name)) and any(changing.fullmatch(word) for word in session.argv[1:]):
            keys = keys_of(session.stdin, session.stdout, session.stderr)
            words = [word for word in session.argv[1:] if "/" in word or (session.cwd / word).exists()]
            paths = [session.cwd / word for word in words]
            if not await agreed(session.name, paths, keys, session.stderr, session.env):
                return 1
        from day6_core.shell.process.process import run_process

        session.env = {**session.env, "LANGUAGE": "en"}  # as ours say it; cards match it
        argv = [tool, *_AT_ONCE.get(name, ()), *session.argv[1:]]
        return await run_process(session, argv, session.argv[0], may_leave_others=name == "find")

    return main


def _names_a_simulated_file(session: Session) -> bool:
    from day6_core.shell.system_files import TEXTS

    return any(word in TEXTS for word in session.argv[1:])


def _tool(name: str, session: Session) -> str:
    """Return the machine's tool, if it is GNU's or answers as GNU's does; '' without one."""
    if not MACHINES:
        return ""
    if sys.platform == "darwin":
        return find_tool(f"g{name}", session.env, session.cwd)
    return find_tool(name, session.env, session.cwd)
