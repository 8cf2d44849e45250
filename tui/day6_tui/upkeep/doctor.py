"""`day6-tui doctor`: the report that a question about day6-tui needs, as plain lines that can be pasted anywhere.

No line has a secret, the name of the user or of the machine; the home folder is ~.
"""

from __future__ import annotations

import getpass
import os
import re
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path
from queue import Empty

from day6_core.command_line.parser import CommandParser, command_parser
from day6_core.inbox import Inbox
from day6_core.isolation.cell import Phrase
from day6_core.language import language_of
from day6_core.places import shortened
from day6_core.reason import fault
from day6_core.session.harmless import one_line
from day6_core.width import text_width
from day6_tui.locale import Texts
from day6_tui.upkeep.checks import CHECKS
from day6_tui.upkeep.line import LEVELS, Line, problem

SHORTEST_NAME = 3
"""Letters of a user's name that is hidden: a shorter one would be found in other words."""


def main(words: list[str]) -> int:
    """`day6-tui doctor`; returns 0 if no line is a problem, else 1."""
    language = language_of(os.environ, words)
    build_parser(language).parse_args(words)
    texts = Texts(language)
    counts = dict.fromkeys(LEVELS, 0)
    width = max(text_width(texts(f"doctor.level.{level}")) for level in LEVELS)
    for check, seconds in CHECKS:
        for line in bounded(check, seconds):
            counts[line.level] += 1
            for each in written(line, texts, width):
                print(each, flush=True)
    print()
    print(texts("doctor.sum" if counts["problem"] else "doctor.sum.fine", **counts))
    return 1 if counts["problem"] else 0


def build_parser(language: str = "en") -> CommandParser:
    """`day6-tui doctor` has no options of its own."""
    return command_parser("doctor", language)


def bounded(check: Callable[[], Iterable[Line]], seconds: float) -> Iterator[Line]:
    """Yield the lines of a check as they come; one that stands still or fails is a problem itself."""
    lines: Inbox[Line | None] = Inbox()
    name = check.__name__

    def work() -> None:
        try:
            for line in check():
                lines.put(line)
        except TimeoutError as error:
            lines.put(problem("check.late", "check.late.todo", name=name, seconds=str(error)))
        except Exception as error:  # a fault of ours, or a machine that nobody has thought of: the report says so
            reason = fault(error)
            lines.put(problem("check.failed", "check.failed.todo", name=name, reason=reason))
        finally:
            lines.put(None)

    threading.Thread(target=work, name=f"day6-doctor-{name}", daemon=True).start()
    while True:
        try:
            line = lines.get(timeout=seconds)
        except Empty:
            yield problem("check.late", "check.late.todo", name=name, seconds=f"{seconds:.0f} s")
            return
        if line is None:
            return
        yield line


def written(line: Line, texts: Texts, width: int) -> Iterator[str]:
    """Yield a line as it is printed, and below it what to do."""
    level = texts(f"doctor.level.{line.level}")
    values = {name: _shown(value, texts) for name, value in line.values.items()}
    yield f"{level}{' ' * (width - text_width(level))}  {anonymous(one_line(texts(f'doctor.{line.key}', **values)))}"
    if line.todo:
        yield f"{' ' * width}  -> {anonymous(one_line(texts(f'doctor.{line.todo}', **values)))}"


def _shown(value: object, texts: Texts) -> str:
    if isinstance(value, Phrase):
        return texts(value.key, **value.values)
    return shortened(value) if isinstance(value, Path) else str(value)


def anonymous(text: str) -> str:
    """Return a text without the home folder and the user's name, wherever they stand."""
    for home in _homes():
        text = re.sub(rf"{re.escape(home)}(?![\w.-])", "~", text)
    name = _user()
    return (
        re.sub(rf"(?<!\w){re.escape(name)}(?!\w)", "USER", text)
        if len(name) >= SHORTEST_NAME and name != "root"
        else text
    )


@cache
def _homes() -> list[str]:
    """The home folder as the variables name it, then as the system does: in the desktop they differ."""
    found = [os.path.expanduser("~")]
    if sys.platform != "win32":
        import pwd

        try:
            found.append(pwd.getpwuid(os.getuid()).pw_dir)
        except KeyError:
            return found
    return [each.rstrip(os.sep) for each in dict.fromkeys(found) if len(each) > 1]


@cache
def _user() -> str:
    try:
        return getpass.getuser()
    except (KeyError, OSError):  # nobody's number, as in some containers
        return ""
