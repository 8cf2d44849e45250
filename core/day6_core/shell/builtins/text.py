"""head, tail, wc, sort, uniq."""

from __future__ import annotations

import errno
import os
import re
from collections import deque
from collections.abc import AsyncIterator, Callable
from pathlib import Path

from day6_core import deep
from day6_core.session.blocking_files import refuse
from day6_core.session.session import Session
from day6_core.session.streams import FileInput, InputStream
from day6_core.session.task import let_others_run
from day6_core.session.threads import in_thread
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.byte_text import joined, of_byte, of_code
from day6_core.shell.outside import agreed, keys_of
from day6_core.shell.own_streams import own_input, own_output, table_of
from day6_core.whole_file import must_stay, overwrite_file, replace_file

_ESCAPES = {
    "n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "e": "\x1b", "E": "\x1b", "f": "\f", "v": "\v", "\\": "\\", "0": "\0",
}  # fmt: skip
_ESCAPE = re.compile(r"\\(0[0-7]{1,3}|[0-7]{1,3}|x[0-9a-fA-F]{1,2}|u[0-9a-fA-F]{4}|.)", re.DOTALL)
_STOP_OUTPUT = "\\c"
LONG = 65536
"""Characters of a line after which other programs get their turn."""
LONGEST_TEXT = 64 * 1024 * 1024
"""Characters held in memory at once: a shell on a machine this small would not get more either."""


def unescape(text: str) -> str:
    """Resolve backslash escapes as `echo -e` and printf do; an unknown one is kept."""

    def one(match: re.Match[str]) -> str:
        code = match[1]
        if code[0] == "x" and len(code) > 1:
            return of_byte(int(code[1:], 16))
        if code[0] == "u" and len(code) > 1:
            return of_code(int(code[1:], 16))
        if code[0] in "01234567" and code != "0":
            return of_byte(int(code, 8) & 0xFF)
        return _ESCAPES.get(code, match[0])

    return joined(_ESCAPE.sub(one, text))


async def lines_of(
    session: Session, names: list[str], problems: list[str], refusal: str = "{name}: {reason}"
) -> AsyncIterator[tuple[str, str]]:
    """Yield (name, line) of the files, or of standard input when there are none or the name is '-'.

    Files that cannot be read are reported as `command: name: reason`, or in the words of `refusal` (none: not at all), and added
    to `problems`.
    """
    for name in names or ["-"]:
        stream: InputStream
        if name in ("-", "/dev/stdin"):
            stream = session.stdin
        else:
            try:
                own = own_input(session.cwd / name, table_of(session))
                if own is None and deep.is_folder(session.cwd / name, follow=True):
                    raise IsADirectoryError(21, "Is a directory")
                stream = own or FileInput(session.cwd / name)
            except OSError as error:
                if refusal:
                    complain(session, refusal.format(name=name, reason=reason(error)))
                problems.append(name)
                continue
        try:
            while line := await stream.read_line():
                yield name, line
                await session.stdout.drain()
                if len(line) > LONG:
                    await let_others_run()
        finally:
            if isinstance(stream, FileInput) and stream is not session.stdin:
                stream.close()


async def text_named(session: Session, name: str) -> str:
    """Read at once what `name` means to a command: a file, or one of its own streams. Raises OSError."""
    own = own_input(session.cwd / name, table_of(session))
    return whole_text(session.cwd / name) if own is None else await own.read_all()


async def script_named(session: Session, name: str) -> str:
    """Read a script at once; editors of Windows end its lines with what is to bash a part of the last word. Raises OSError."""
    text = await text_named(session, name)
    return text.replace("\r\n", "\n") if os.name == "nt" else text


def whole_text(path: Path) -> str:
    """Read a file at once. Raises OSError, also for a file that is too large (/dev/zero has no end)."""
    refuse(str(path), deep.status(path, follow=True).st_mode, writing=False)
    with open(deep.open_file(path, os.O_RDONLY), encoding="utf-8", errors="surrogateescape", newline="\n") as file:
        text = file.read(LONGEST_TEXT + 1)
    if len(text) > LONGEST_TEXT:
        raise OSError(errno.ENOMEM, "Cannot allocate memory")
    return text


_CANNOT_OPEN = "cannot open '{name}' for reading: {reason}"


async def head(session: Session) -> int:
    return await _ends(session, first=True)


async def tail(session: Session) -> int:
    return await _ends(session, first=False)


_UNITS = {"": 1, "b": 512, "kB": 1000, "K": 1024, "k": 1024, "KiB": 1024, "MB": 1000**2, "M": 1024**2, "MiB": 1024**2,
          "GB": 1000**3, "G": 1024**3, "GiB": 1024**3}  # fmt: skip


async def _ends(session: Session, *, first: bool) -> int:
    try:
        long = {"--lines": "n", "--bytes": "c", "--quiet": "q", "--follow": "f"}
        options, names = parse(session.argv, "qvfF", "nc", long, dash_number=True)
    except UsageError as error:
        complain(session, error)
        return 1
    in_bytes = "c" in options
    text = options.get("c" if in_bytes else "n", "10")
    number = re.fullmatch(r"([+-]?\d+)(\w*)", text)
    if number is None or number[2] not in _UNITS:
        complain(session, f"invalid number of {'bytes' if in_bytes else 'lines'}: ‘{text}’")
        return 1
    count = int(number[1]) * _UNITS[number[2]]
    problems: list[str] = []
    for index, name in enumerate(names or ["-"]):
        if len(names) > 1 and "q" not in options and (name == "-" or os.access(session.cwd / name, os.R_OK)):
            title = "standard input" if name == "-" else name
            session.print(f"{chr(10) if index else ''}==> {title} <==")
        if in_bytes:
            await _some_bytes(session, name, count, text, problems, first=first)
        elif first and count >= 0:
            await _first_lines(session, name, count, problems)
        else:
            await _last_lines(session, name, count, text, problems, first=first)
    if "f" in options or "F" in options:
        await _follow(session, names)
    return 1 if problems else 0


async def _first_lines(session: Session, name: str, count: int, problems: list[str]) -> None:
    if count == 0:
        return
    async for _, line in lines_of(session, [name], problems, _CANNOT_OPEN):
        session.stdout.write(line)
        count -= 1
        if count <= 0:
            break


async def _last_lines(session: Session, name: str, count: int, text: str, problems: list[str], *, first: bool) -> None:
    if not first and text.startswith("+"):  # tail -n +3: from the third line on
        skip = count - 1
        async for _, line in lines_of(session, [name], problems, _CANNOT_OPEN):
            if skip > 0:
                skip -= 1
            else:
                session.stdout.write(line)
        return
    kept: deque[str] = deque()
    keep = abs(count)
    async for _, line in lines_of(session, [name], problems, _CANNOT_OPEN):
        kept.append(line)
        if len(kept) > keep:
            oldest = kept.popleft()
            if first:  # head -n -3: all but the last three
                session.stdout.write(oldest)
    if not first:
        session.stdout.write("".join(kept))


async def _some_bytes(session: Session, name: str, count: int, text: str, problems: list[str], *, first: bool) -> None:
    """Print the first or last bytes: what is left of a character that was cut is passed on as it is."""

    def write(data: bytes) -> None:
        session.stdout.write(data.decode("utf-8", "surrogateescape"))

    begins_late = not first and text.startswith("+")
    skip, left = max(0, count - 1) if begins_late else 0, count if first and count >= 0 else None
    kept = bytearray()
    async for _, line in lines_of(session, [name], problems, _CANNOT_OPEN):
        data = line.encode("utf-8", "surrogateescape")
        if left is not None:
            write(data[:left])
            left -= min(left, len(data))
            if not left:
                return
        elif begins_late:
            write(data[skip:])
            skip = max(0, skip - len(data))
        else:
            kept += data
            over = max(0, len(kept) - abs(count))
            if first:  # head -c -3: all but the last three
                write(bytes(kept[:over]))
            del kept[:over]
    if not first and not begins_late:
        write(bytes(kept))


async def _follow(session: Session, names: list[str]) -> None:
    """Print what is appended to the files, until interrupted."""
    places = {name: (session.cwd / name).stat().st_size for name in names if (session.cwd / name).is_file()}
    async for _ in session.every(0.2):
        for name, place in places.items():
            path = session.cwd / name
            size = path.stat().st_size if path.exists() else 0
            if size > place:
                with path.open("rb") as file:
                    file.seek(place)
                    session.stdout.write(file.read().decode("utf-8", "surrogateescape"))
            places[name] = size


async def wc(session: Session) -> int:
    try:
        options, names = parse(
            session.argv, "lwcm", "", {"--lines": "l", "--words": "w", "--bytes": "c", "--chars": "m"}
        )
    except UsageError as error:
        complain(session, error)
        return 1
    wanted = [letter for letter in "lwmc" if letter in options] or ["l", "w", "c"]
    problems: list[str] = []
    rows: list[tuple[list[int], str]] = []
    size = 0
    for name in names or ["-"]:
        found = dict.fromkeys("lwmc", 0)
        already = len(problems)
        async for _, line in lines_of(session, [name], problems):
            found["l"] += line.endswith("\n")
            found["w"] += sum(word.isprintable() or any(map(str.isprintable, word)) for word in line.split())
            found["m"] += len(line) if line.isascii() else len(line.encode("utf-8", "ignore").decode())
            found["c"] += len(line.encode("utf-8", "surrogateescape"))
        size += found["c"]
        if len(problems) == already:
            rows.append(([found[letter] for letter in wanted], "" if not names else name))
    if len(names) > 1:
        rows.append(
            (
                [sum(column) for column in zip(*(counts for counts, _ in rows), strict=True)] or [0] * len(wanted),
                "total",
            )
        )
    # GNU wc makes room for the bytes of all files, whatever it counts.
    width = (
        (len(str(size)) if names or isinstance(session.stdin, FileInput) else 7)
        if len(wanted) > 1 or len(names) > 1
        else 1
    )
    for counts, name in rows:
        session.print(" ".join(f"{count:>{width}}" for count in counts) + (f" {name}" if name else ""))
    return 1 if problems else 0


async def sort(session: Session) -> int:
    try:
        options, names = parse(
            session.argv,
            "rnufbs",
            "kot",
            {"--reverse": "r", "--numeric-sort": "n", "--unique": "u", "--ignore-case": "f", "--output": "o",
             "--key": "k", "--field-separator": "t"},
            "k",
        )  # fmt: skip
        if "\n" in options.get("k", ""):
            raise UsageError("day6-tui's own sort takes one -k")
        key = _sort_key(options)
    except UsageError as error:
        complain(session, error)
        return 2
    problems: list[str] = []
    lines = []
    size = 0
    async for _, line in lines_of(session, names, problems, "cannot read: {name}: {reason}"):
        lines.append(line.rstrip("\n"))
        size += len(line)
        if size > LONGEST_TEXT:
            complain(session, "memory exhausted")
            return 2
    if problems:  # GNU's sort begins to write when it has read everything
        return 2
    if "u" in options:
        lines = list({key(line): line for line in reversed(lines)}.values())
    # Lines with the same key stand in the order of their characters.
    lines.sort(key=lambda line: (key(line), line), reverse="r" in options)
    text = "".join(line + "\n" for line in lines)
    if "o" in options:
        return await _sorted_into(session, options["o"], text)
    session.stdout.write(text)
    return 0


def _sort_key(options: dict[str, str]) -> Callable[[str], tuple[float, str]]:
    """Return the sort key that `-k FIELD[,FIELD]`, `-n`, `-f` and `-t` select. Raises UsageError."""
    match = re.fullmatch(r"([1-9]\d*)([nfrb]*)(?:,(\d+)([nfrb]*))?", options.get("k", "1"))
    if match is None:
        raise UsageError(f"invalid number at field start: invalid count at start of ‘{options['k']}’")
    first, last = int(match[1]) - 1, int(match[3]) if match[3] else None
    letters = {*options, *match[2], *(match[4] or "")}
    if "r" in letters:
        options["r"] = "r"

    def key(line: str) -> tuple[float, str]:
        separator = options.get("t")
        text = (separator or " ").join(line.split(separator)[first:last]) if "k" in options else line
        if "n" in letters:
            number = re.match(r"\s*-?\d*(?:\.\d+)?", text)
            return float(number[0]) if number is not None and number[0].strip() not in ("", "-") else 0.0, ""
        return 0.0, text.upper() if "f" in letters else text

    return key


async def _sorted_into(session: Session, name: str, text: str) -> int:
    """`sort -o NAME`, which may be one of the files that were sorted: it stays whole if there is no room."""
    path = session.cwd / name
    if not await agreed(session.name, [path], keys_of(session.stdin, session.stdout), session.stderr, session.env):
        return 2
    try:
        await write_named(session, name, text.encode("utf-8", "surrogateescape"))
    except OSError as error:
        failed = "write" if error.errno in (errno.ENOSPC, errno.EFBIG, errno.EDQUOT) else "open"
        complain(session, f"{failed} failed: {name}: {reason(error)}")
        return 2
    return 0


async def write_named(session: Session, name: str, data: bytes) -> None:
    """Write `data` to what `name` means to a command: a file, or one of its own streams. Raises OSError."""
    own = own_output(session.cwd / name, table_of(session))
    if own is None:
        path = session.cwd / name
        if name.endswith("/") and not path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), name)
        write = overwrite_file if must_stay(path) else replace_file
        await in_thread(lambda: write(path, data))
    else:
        own.write(data.decode("utf-8", "surrogateescape"))
        await own.drain()


async def uniq(session: Session) -> int:
    try:
        options, names = parse(session.argv, "cdu", "", {"--count": "c"})
    except UsageError as error:
        complain(session, error)
        return 1
    problems: list[str] = []
    previous: str | None = None
    count = 0
    at_once = not options
    """Nothing depends on how often a line comes: it is shown when it comes, as behind `ros2 topic echo --csv /a |`."""

    def show() -> None:
        if previous is None or at_once:
            return
        if not ("d" in options and count < 2) and not ("u" in options and count > 1):
            session.print(f"{count:>7} {previous}" if "c" in options else previous)

    async for _, line in lines_of(session, names, problems):
        text = line.rstrip("\n")
        if text == previous:
            count += 1
        else:
            show()
            previous, count = text, 1
            if at_once:
                session.print(text)
    show()
    return 1 if problems else 0
