"""read and mapfile: lines of the input become variables."""

from __future__ import annotations

from collections.abc import Awaitable, Callable

from day6_core.session.session import Session
from day6_core.session.streams import InputStream
from day6_core.session.task import Signal
from day6_core.shell.builtins.options import UsageError, complain_as_shell, parse
from day6_core.shell.language.assignments import key_of, split_target
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.language.words import SyntaxProblem

_TIMED_OUT = 142
_BLANK = " \t\n"
Characters = list[tuple[str, bool]]
"""Characters, each with whether a backslash was before it."""


async def read(session: Session) -> int:
    """`read [-rs] [-a NAME] [-d DELIMITER] [-n COUNT] [-N COUNT] [-p PROMPT] [-t SECONDS] [-u DESCRIPTOR] [NAME …]`."""
    shell = shell_of(session)
    try:
        options, names = parse(session.argv, "rse", "pdnNuta")
        count = int(options.get("N", options.get("n", "-1")))
        timeout = float(options["t"]) if "t" in options else None
    except (UsageError, ValueError) as problem:
        complain_as_shell(session, str(problem).partition("\n")[0])
        return 2
    stdin = _input(session, options.get("u"))
    if stdin is None:
        return 1
    for name in [*names, *([options["a"]] if "a" in options else [])]:
        if split_target(f"{name}=") is None:
            complain_as_shell(session, f"`{name}': not a valid identifier")
            return 1
    if "p" in options and stdin.isatty():
        session.stderr.write(options["p"])
    end = options["d"][:1] or "\0" if "d" in options else "\n"
    if "N" in options:
        end = ""
    source = _Reader(stdin, raw="r" in options, end=end, count=count)
    if timeout is None:
        ended = await source.read()
    else:
        finished = await _within(session, timeout, source.read)
        ended = bool(finished)
        if finished is None:
            return _TIMED_OUT
    try:
        await _give(session, source.found, names, options)
    except SyntaxProblem as problem:
        session.print_error(f"{shell.name}: {problem}")
        return 1
    return 0 if ended else 1


def _input(session: Session, descriptor: str | None) -> InputStream | None:
    """What `-u` names, standard input without it; None, with a complaint, for what can't be read."""
    if descriptor is None:
        return session.stdin
    streams = shell_of(session).all_streams(session)
    stream = streams.table.get(int(descriptor)) if descriptor.isdigit() else None
    if isinstance(stream, InputStream):
        return stream
    complain_as_shell(session, f"{descriptor}: invalid file descriptor: Bad file descriptor")
    return None


async def _within(session: Session, seconds: float, work: Callable[[], Awaitable[bool]]) -> bool | None:
    """Do something for at most so long; None if it took longer."""
    done = Signal()
    found: list[bool] = []

    async def run() -> None:
        found.append(await work())
        done.set()

    task = session.spawn(run())
    if not await session.wait(done, max(seconds, 0.001)):
        task.cancel()
        return None
    return found[0]


class _Reader:
    """Reads up to a delimiter, or so many characters."""

    def __init__(self, stdin: InputStream, *, raw: bool, end: str, count: int) -> None:
        self.stdin = stdin
        self.raw = raw
        self.end = end
        self.count = count
        self.found: Characters = []

    async def read(self) -> bool:
        """Read; return whether the delimiter, or the number of characters, was reached."""
        if self.end == "\n" and self.count < 0:
            return await self._lines()
        while self.count < 0 or len(self.found) < self.count:
            char = await self.stdin.read_key()
            if not char:
                return False
            if char == self.end:
                return True
            if char == "\\" and not self.raw:
                char = await self.stdin.read_key()
                if char != "\n" and char:
                    self.found.append((char, True))
            elif char != "\0":
                self.found.append((char, False))
        return True

    async def _lines(self) -> bool:
        while True:
            line = await self.stdin.read_line()
            text = line.removesuffix("\n").replace("\0", "")
            if self.raw:
                self.found = [(char, False) for char in text]
                return line.endswith("\n")
            at = 0
            while at < len(text):
                if text[at] == "\\":
                    at += 1
                    if at == len(text):
                        break
                    self.found.append((text[at], True))
                else:
                    self.found.append((text[at], False))
                at += 1
            else:
                return line.endswith("\n")
            if not line.endswith("\n"):
                return False


async def _give(session: Session, found: Characters, names: list[str], options: dict[str, str]) -> None:
    """Split what was read at IFS, and assign the pieces."""
    shell = shell_of(session)
    if "a" in options:
        pieces = split(found, shell.separators, None)
        shell.variables.assign_array(options["a"], [(None, piece, False) for piece in pieces])
        return
    if not names:
        shell.variables.assign("REPLY", "".join(char for char, _ in found))
        return
    if "N" in options:
        pieces = ["".join(char for char, _ in found)]
    else:
        pieces = split(found, shell.separators, len(names))
    for index, name in enumerate(names):
        target = split_target(f"{name}=")
        assert target is not None
        key = None if target[1] is None else await key_of(target[0], target[1], shell, shell.all_streams(session))
        shell.variables.assign(target[0], pieces[index] if index < len(pieces) else "", key=key)


def split(found: Characters, separators: str, most: int | None) -> list[str]:
    """Split into at most `most` pieces: a run of white space is one separator, any other separator counts each time."""

    def is_blank(at: int) -> bool:
        return at < len(found) and not found[at][1] and found[at][0] in separators and found[at][0] in _BLANK

    def is_other(at: int) -> bool:
        return at < len(found) and not found[at][1] and found[at][0] in separators and found[at][0] not in _BLANK

    def skip(at: int) -> int:
        while is_blank(at):
            at += 1
        return at

    def piece(at: int) -> tuple[str, int]:
        """The piece that begins at `at`, and where the next one does."""
        start = at
        while at < len(found) and not is_blank(at) and not is_other(at):
            at += 1
        end, at = at, skip(at)
        if is_other(at):
            at = skip(at + 1)
        return "".join(char for char, _ in found[start:end]), at

    pieces: list[str] = []
    at = skip(0)
    while at < len(found):
        if most is not None and len(pieces) == most - 1:
            text, following = piece(at)
            if following < len(found):  # more pieces than names: the rest as it is, without the white space at its end
                end = len(found)
                while is_blank(end - 1):
                    end -= 1
                text = "".join(char for char, _ in found[at:end])
            return [*pieces, text]
        text, at = piece(at)
        pieces.append(text)
    return pieces


async def mapfile(session: Session) -> int:
    """`mapfile [-t] [-d DELIMITER] [-n COUNT] [-O ORIGIN] [-s COUNT] [-u DESCRIPTOR] [NAME]`: each line is an element."""
    shell = shell_of(session)
    try:
        options, names = parse(session.argv, "t", "dnOsu")
        most, first, skipped = (int(options.get(letter, "0")) for letter in "nOs")
    except (UsageError, ValueError) as problem:
        complain_as_shell(session, str(problem).partition("\n")[0])
        return 1
    stdin = _input(session, options.get("u"))
    if stdin is None:
        return 1
    name = names[0] if names else "MAPFILE"
    end = (options["d"][:1] or "\0") if "d" in options else "\n"
    items: list[tuple[str | None, str, bool]] = []
    while not most or len(items) < most:
        line = await _line(stdin, end)
        if not line:
            break
        if skipped:
            skipped -= 1
            continue
        text = line.removesuffix(end) if "t" in options else line
        items.append((str(first + len(items)), text.replace("\0", ""), False))
        await session.stdout.drain()
    try:
        shell.variables.assign_array(name, items, append="O" in options)
    except SyntaxProblem as problem:
        complain_as_shell(session, problem)
        return 1
    return 0


async def _line(stdin: InputStream, end: str) -> str:
    if end == "\n":
        return await stdin.read_line()
    found: list[str] = []
    while char := await stdin.read_key():
        found.append(char)
        if char == end:
            break
    return "".join(found)
