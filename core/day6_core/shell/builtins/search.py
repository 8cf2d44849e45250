"""grep."""

from __future__ import annotations

import os
import re
import stat
from collections import deque

from day6_core import deep
from day6_core.session.session import Session
from day6_core.session.task import in_turns
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.builtins.text import lines_of
from day6_core.user_pattern import TooComplex, UserPattern

_GREP_LONG = {
    "--ignore-case": "i",
    "--invert-match": "v",
    "--line-number": "n",
    "--count": "c",
    "--extended-regexp": "E",
    "--fixed-strings": "F",
    "--word-regexp": "w",
    "--only-matching": "o",
    "--quiet": "q",
    "--silent": "q",
    "--files-with-matches": "l",
    "--recursive": "r",
    "--max-count": "m",
    "--regexp": "e",
    "--after-context": "A",
    "--before-context": "B",
    "--context": "C",
    "--color": "K",
    "--colour": "K",
    "--line-buffered": "U",
    "--no-filename": "h",
    "--with-filename": "H",
    "--text": "a",
}


async def grep(session: Session) -> int:
    try:
        # Of all options with a value this one need not have it.
        words = ["--color=auto" if word in ("--color", "--colour") else word for word in session.argv]
        options, names = parse(words, "ivncEFGPwxoqlrRhHaUs", "meABCK", _GREP_LONG, joined="e")
    except UsageError as error:
        complain(session, error)
        return 2
    pattern = options.get("e")
    if pattern is None:
        if not names:
            session.print_error("Usage: grep [OPTION]... PATTERNS [FILE]...\nTry 'grep --help' for more information.")
            return 2
        pattern = names.pop(0)
    try:
        expression = _grep_expression(pattern, options)
        context = int(options.get("C", "0"))
        before, after = int(options.get("B", context)), int(options.get("A", context))
        most = int(options.get("m", "-1"))
    except re.error as error:
        complain(session, str(error).capitalize())
        return 2
    except ValueError:
        wrong = next(options[letter] for letter in "CBAm" if not options.get(letter, "0").lstrip("-").isdigit())
        complain(
            session, "invalid max count" if wrong == options.get("m") else f"{wrong}: invalid context length argument"
        )
        return 2
    recursive = bool({"r", "R"} & options.keys())
    several = len(names) > 1 or (recursive and any((session.cwd / name).is_dir() for name in names or ["."]))
    show_name = ("H" in options or several) and "h" not in options
    if recursive:
        names = _all_files(session, names)
    search = _Grep(session, expression, options, show_name, before, after, most)
    problems: list[str] = []
    try:
        async for name, line in lines_of(session, names, problems, "" if "s" in options else "{name}: {reason}"):
            if not await search.line(name, line):
                break
    except TooComplex as error:
        complain(session, str(error))
        return 2
    return search.finish(bool(problems))


def _grep_expression(pattern: str, options: dict[str, str]) -> UserPattern:
    """Return one expression for a list of patterns, one per line: a line of text matches if any of them does."""
    pieces = pattern.split("\n")
    if "F" in options:
        pieces = [re.escape(piece) for piece in pieces]
    elif "E" not in options and "P" not in options:
        # Basic expressions: \| \( \{ \+ \? are the operators, the plain characters mean themselves.
        pieces = [
            re.sub(r"\\([|(){}+?])|([|(){}+?])", lambda m: m[1] if m[1] else "\\" + m[2], piece) for piece in pieces
        ]
    if "F" not in options:
        pieces = [re.sub(r"\[:(\w+):\]", lambda m: _CLASSES.get(m[1], m[0]), piece) for piece in pieces]
    for piece in pieces:
        UserPattern(piece)  # a mistake is that of one pattern
    pattern = pieces[0] if len(pieces) == 1 else "|".join(f"(?:{piece})" for piece in pieces)
    if "w" in options:
        pattern = rf"\b(?:{pattern})\b"
    if "x" in options:
        pattern = rf"\A(?:{pattern})\Z"
    return UserPattern(pattern, re.IGNORECASE if "i" in options else 0)


_CLASSES = {
    "digit": "0-9",
    "space": r"\s",
    "blank": r" \t",
    "alpha": "A-Za-z",
    "alnum": "A-Za-z0-9",
    "upper": "A-Z",
    "lower": "a-z",
    "punct": r"!-/:-@\[-`{-~",
    "xdigit": "0-9A-Fa-f",
}
"""`[:digit:]` and the other classes, as they are written inside brackets."""


def _all_files(session: Session, names: list[str]) -> list[str]:
    found: list[str] = []
    for name in names or [""]:
        waiting = [name]
        while waiting:
            inner = waiting.pop()
            if deep.is_folder(path := os.path.join(session.cwd, inner), follow=inner == name):
                try:
                    waiting += (os.path.join(inner, each) for each in sorted(deep.names_in(path), reverse=True))
                except OSError as error:
                    complain(session, f"{inner}: {reason(error)}")
            elif inner == name or stat.S_ISREG(deep.mode(path, follow=True)):
                found.append(inner)
    return found


class _Grep:
    """The state of one run of grep."""

    def __init__(
        self,
        session: Session,
        expression: UserPattern,
        options: dict[str, str],
        show_name: bool,
        before: int,
        after: int,
        most: int,
    ) -> None:
        self.session, self.expression, self.options, self.show_name = session, expression, options, show_name
        self.earlier: deque[tuple[int, str]] = deque(maxlen=before)
        self.after, self.most = after, most
        self.number, self.name, self.count, self.total, self.left = 0, "", 0, 0, 0
        self.shown, self.shown_of = 0, ""
        self.colour = session.stdout.isatty() or "always" in options.get("K", "")

    async def line(self, name: str, line: str) -> bool:
        """Handle one line; False when nothing more needs to be read."""
        if name != self.name:
            self._file_done()
            self.name, self.number, self.count, self.left = name, 0, 0, 0
            self.earlier.clear()
        self.number += 1
        text = line.rstrip("\n")
        match = await in_turns(self.expression.searching(text))
        if (match is None) == ("v" not in self.options):
            if self.left:
                self.left -= 1
                await self._show(self.number, text, "-")
            else:
                self.earlier.append((self.number, text))
            return True
        self.count += 1
        self.total += 1
        if "q" in self.options:
            return False
        if not ({"c", "l"} & self.options.keys()):
            gap = self.number - len(self.earlier) > self.shown + 1 or self.shown_of != self.name
            if (self.after or self.earlier.maxlen) and self.shown and gap:
                self.session.print("--")
            for number, earlier in self.earlier:
                await self._show(number, earlier, "-")
            self.earlier.clear()
            self.left = self.after
            await self._show(self.number, text, ":")
        return self.most < 0 or self.count < self.most

    async def _show(self, number: int, text: str, mark: str) -> None:
        self.shown, self.shown_of = number, self.name
        prefix = (
            (self.name.replace("-", "(standard input)", 1) if self.name == "-" else self.name) + mark
            if self.show_name
            else ""
        )
        prefix += f"{number}{mark}" if "n" in self.options else ""
        if "o" in self.options and mark == ":":
            for match in await in_turns(self.expression.finding(text)):
                self.session.print(prefix + self._painted(match.whole))
            return
        if self.colour and mark == ":" and "v" not in self.options:
            text = await in_turns(self.expression.replacing(text, lambda match: self._painted(match.whole)))
        self.session.print(prefix + text)

    def _painted(self, text: str) -> str:
        return f"\x1b[01;31m{text}\x1b[0m" if self.colour and text else text

    def _file_done(self) -> None:
        if not self.name or "q" in self.options:
            return
        if "l" in self.options:
            if self.count:
                self.session.print(self.name)
        elif "c" in self.options:
            self.session.print(f"{self.name}:{self.count}" if self.show_name else self.count)

    def finish(self, problems: bool) -> int:
        if not self.name and "c" in self.options:
            self.session.print(0)
        self._file_done()
        if problems and not ("q" in self.options and self.total):
            return 2
        return 0 if self.total else 1


async def egrep(session: Session) -> int:
    """`egrep` and `fgrep`: the old names of `grep -E` and `grep -F`."""
    kind = "-E" if session.name == "egrep" else "-F"
    return await session.execute(grep, ["grep", kind, *session.argv[1:]])
