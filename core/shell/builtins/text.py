"""echo, printf, grep, head, tail, wc, sort, uniq."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import AsyncIterator

from day6_tui.core.session.session import Main, Session
from day6_tui.core.session.streams import FileInput, InputStream
from day6_tui.core.shell.builtins.options import UsageError, complain, parse, reason

_ESCAPES = {
    "n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "e": "\x1b", "E": "\x1b", "f": "\f", "v": "\v", "\\": "\\", "0": "\0",
}  # fmt: skip
_ESCAPE = re.compile(r"\\(0[0-7]{1,3}|[0-7]{1,3}|x[0-9a-fA-F]{1,2}|u[0-9a-fA-F]{4}|.)", re.DOTALL)
_STOP_OUTPUT = "\\c"


def unescape(text: str) -> str:
    """Resolve backslash escapes as `echo -e` and printf do; an unknown one stays."""

    def one(match: re.Match[str]) -> str:
        code = match[1]
        if code[0] in "xu" and len(code) > 1:
            return chr(int(code[1:], 16))
        if code[0] in "01234567" and code != "0":
            return chr(int(code, 8) & 0xFF)
        return _ESCAPES.get(code, match[0])

    return _ESCAPE.sub(one, text)


async def echo(session: Session) -> int:
    words = session.argv[1:]
    newline, escapes = True, False
    while words and re.fullmatch(r"-[neE]+", words[0]):
        for letter in words.pop(0)[1:]:
            newline = newline and letter != "n"
            escapes = {"e": True, "E": False}.get(letter, escapes)
    text = " ".join(words)
    if escapes:
        text, stop, _ = text.partition(_STOP_OUTPUT)
        text = unescape(text)
        newline = newline and not stop
    session.print(text, end="\n" if newline else "")
    return 0


async def printf(session: Session) -> int:
    if len(session.argv) < 2:
        session.print_error("bash: printf: usage: printf [-v var] format [arguments]")
        return 2
    pattern, values = unescape(session.argv[1]), session.argv[2:]
    status = 0
    while True:
        before = len(values)
        text, ok = _format(pattern, values, session)
        session.stdout.write(text)
        status = status or (0 if ok else 1)
        if not values or len(values) == before:
            return status


def _format(pattern: str, values: list[str], session: Session) -> tuple[str, bool]:
    ok = True

    def one(match: re.Match[str]) -> str:
        nonlocal ok
        flags, kind = match[1], match[2]
        if kind == "%":
            return "%"
        value = values.pop(0) if values else ""
        if kind in "sc":
            return f"%{flags}s" % (value[:1] if kind == "c" else value)
        if kind == "b":
            return f"%{flags}s" % unescape(value)
        try:
            number = float(value or 0) if kind in "eEfFgG" else int(value or "0", 0)
        except ValueError:
            session.print_error(f"bash: printf: {value}: invalid number")
            ok, number = False, 0
        return f"%{flags}{kind}" % number

    return re.sub(r"%([-+ #0]*\d*(?:\.\d+)?)([%sbcdiouxXeEfFgG])", one, pattern), ok


async def lines_of(session: Session, names: list[str], problems: list[str]) -> AsyncIterator[tuple[str, str]]:
    """Yield (name, line) of the files, or of standard input when there are none or the name is '-'.

    Files that cannot be read are reported as `command: name: reason` and added to `problems`.
    """
    for name in names or ["-"]:
        stream: InputStream
        if name == "-":
            stream = session.stdin
        else:
            try:
                if (session.cwd / name).is_dir():
                    raise IsADirectoryError(21, "Is a directory")
                stream = FileInput(session.cwd / name)
            except OSError as error:
                complain(session, f"{name}: {reason(error)}")
                problems.append(name)
                continue
        try:
            while line := await stream.read_line():
                yield name, line
                await session.stdout.drain()
        finally:
            if name != "-":
                stream.close()


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
        options, names = parse(session.argv, "ivncEFGPwxoqlrRhHaUs", "meABCK", {**_GREP_LONG})
    except UsageError as error:
        if "--color" in str(error) or "--colour" in str(error):
            session.argv = [word for word in session.argv if word not in ("--color", "--colour")]
            return await grep(session)
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
        complain(session, "context length argument is not a number")
        return 2
    if "r" in options or "R" in options:
        names = _all_files(session, names or ["."])
    show_name = ("H" in options or len(names) > 1) and "h" not in options
    search = _Grep(session, expression, options, show_name, before, after, most)
    problems: list[str] = []
    async for name, line in lines_of(session, names, problems):
        if not search.line(name, line):
            break
    return search.finish(bool(problems))


def _grep_expression(pattern: str, options: dict[str, str]) -> re.Pattern[str]:
    if "F" in options:
        pattern = "|".join(re.escape(piece) for piece in pattern.split("\n"))
    elif "E" not in options and "P" not in options:
        # Basic expressions: \| \( \{ \+ \? are the operators, the plain characters mean themselves.
        pattern = re.sub(r"\\([|(){}+?])|([|(){}+?])", lambda m: m[1] if m[1] else "\\" + m[2], pattern)
    pattern = re.sub(r"\[\[:(\w+):\]\]", lambda m: _CLASSES.get(m[1], m[0]), pattern)
    if "w" in options:
        pattern = rf"\b(?:{pattern})\b"
    if "x" in options:
        pattern = rf"\A(?:{pattern})\Z"
    return re.compile(pattern, re.IGNORECASE if "i" in options else 0)


_CLASSES = {
    "digit": r"\d",
    "space": r"\s",
    "alpha": "[A-Za-z]",
    "alnum": "[A-Za-z0-9]",
    "upper": "[A-Z]",
    "lower": "[a-z]",
}


def _all_files(session: Session, names: list[str]) -> list[str]:
    found: list[str] = []
    for name in names:
        path = session.cwd / name
        if path.is_dir():
            inside = sorted(file for file in path.rglob("*") if file.is_file())
            found.extend(f"{name.rstrip('/')}/{file.relative_to(path)}" for file in inside)
        else:
            found.append(name)
    return found


class _Grep:
    """What one run of grep has found so far."""

    def __init__(
        self,
        session: Session,
        expression: re.Pattern[str],
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
        self.shown = 0
        self.colour = session.stdout.isatty() or "always" in options.get("K", "")

    def line(self, name: str, line: str) -> bool:
        """Handle one line; False when nothing more needs to be read."""
        if name != self.name:
            self._file_done()
            self.name, self.number, self.count, self.left = name, 0, 0, 0
            self.earlier.clear()
        self.number += 1
        text = line.rstrip("\n")
        match = self.expression.search(text)
        if (match is None) == ("v" not in self.options):
            if self.left:
                self.left -= 1
                self._show(self.number, text, "-")
            else:
                self.earlier.append((self.number, text))
            return True
        self.count += 1
        self.total += 1
        if "q" in self.options:
            return False
        if not ({"c", "l"} & self.options.keys()):
            if (self.after or self.earlier.maxlen) and self.shown and self.number - len(self.earlier) > self.shown + 1:
                self.session.print("--")
            for number, earlier in self.earlier:
                self._show(number, earlier, "-")
            self.earlier.clear()
            self.left = self.after
            self._show(self.number, text, ":")
        return self.most < 0 or self.count < self.most

    def _show(self, number: int, text: str, mark: str) -> None:
        self.shown = number
        prefix = (
            (self.name.replace("-", "(standard input)", 1) if self.name == "-" else self.name) + mark
            if self.show_name
            else ""
        )
        prefix += f"{number}{mark}" if "n" in self.options else ""
        if "o" in self.options and mark == ":":
            for match in self.expression.finditer(text):
                self.session.print(prefix + self._painted(match[0]))
            return
        if self.colour and mark == ":" and "v" not in self.options:
            text = self.expression.sub(lambda match: self._painted(match[0]), text)
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


async def head(session: Session) -> int:
    return await _ends(session, first=True)


async def tail(session: Session) -> int:
    return await _ends(session, first=False)


async def _ends(session: Session, *, first: bool) -> int:
    try:
        options, names = parse(session.argv, "qvfF", "n", {"--lines": "n", "--quiet": "q", "--follow": "f"})
        text = options.get("n", "10")
        count = int(text)
    except UsageError as error:
        complain(session, error)
        return 1
    except ValueError:
        complain(session, f"invalid number of lines: '{text}'")
        return 1
    problems: list[str] = []
    for index, name in enumerate(names or ["-"]):
        if len(names) > 1:
            session.print(f"{chr(10) if index else ''}==> {name} <==")
        if first and count >= 0:
            await _first_lines(session, name, count, problems)
        else:
            await _last_lines(session, name, count, text, problems, first=first)
    if "f" in options or "F" in options:
        await _follow(session, names)
    return 1 if problems else 0


async def _first_lines(session: Session, name: str, count: int, problems: list[str]) -> None:
    if count == 0:
        return
    async for _, line in lines_of(session, [name], problems):
        session.stdout.write(line)
        count -= 1
        if count <= 0:
            break


async def _last_lines(session: Session, name: str, count: int, text: str, problems: list[str], *, first: bool) -> None:
    if not first and text.startswith("+"):  # tail -n +3: from the third line on
        skip = count - 1
        async for _, line in lines_of(session, [name], problems):
            if skip > 0:
                skip -= 1
            else:
                session.stdout.write(line)
        return
    kept: deque[str] = deque()
    keep = abs(count)
    async for _, line in lines_of(session, [name], problems):
        kept.append(line)
        if len(kept) > keep:
            oldest = kept.popleft()
            if first:  # head -n -3: all but the last three
                session.stdout.write(oldest)
    if not first:
        session.stdout.write("".join(kept))


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
                    session.stdout.write(file.read().decode("utf-8", "replace"))
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
    for name in names or ["-"]:
        found = dict.fromkeys("lwmc", 0)
        already = len(problems)
        async for _, line in lines_of(session, [name], problems):
            found["l"] += line.endswith("\n")
            found["w"] += len(line.split())
            found["m"] += len(line)
            found["c"] += len(line.encode("utf-8", "surrogateescape"))
        if len(problems) == already:
            rows.append(([found[letter] for letter in wanted], "" if not names else name))
    if len(names) > 1:
        rows.append(
            (
                [sum(column) for column in zip(*(counts for counts, _ in rows), strict=True)] or [0] * len(wanted),
                "total",
            )
        )
    widest = max((len(str(count)) for counts, _ in rows for count in counts), default=1)
    width = (widest if names else 7) if len(wanted) > 1 or len(names) > 1 else 1
    for counts, name in rows:
        session.print(" ".join(f"{count:>{width}}" for count in counts) + (f" {name}" if name else ""))
    return 1 if problems else 0


async def sort(session: Session) -> int:
    try:
        options, names = parse(session.argv, "rnuf", "k", {"--reverse": "r", "--numeric-sort": "n", "--unique": "u"})
    except UsageError as error:
        complain(session, error)
        return 2
    problems: list[str] = []
    lines = [line.rstrip("\n") async for _, line in lines_of(session, names, problems)]
    column = int(options["k"].split(",")[0]) - 1 if options.get("k", "").split(",")[0].isdigit() else None

    def key(line: str) -> tuple[float, str]:
        words = line.split()
        text = line if column is None else " ".join(words[column:])
        number = re.match(r"\s*-?\d+(?:\.\d+)?", text) if "n" in options else None
        return (float(number[0]) if number else 0.0, text)

    lines.sort(key=key, reverse="r" in options)
    if "u" in options:
        lines = list(dict.fromkeys(lines))
    session.stdout.write("".join(line + "\n" for line in lines))
    return 2 if problems else 0


async def uniq(session: Session) -> int:
    try:
        options, names = parse(session.argv, "cdu", "", {"--count": "c"})
    except UsageError as error:
        complain(session, error)
        return 1
    problems: list[str] = []
    previous: str | None = None
    count = 0

    def show() -> None:
        if previous is not None and not ("d" in options and count < 2) and not ("u" in options and count > 1):
            session.print(f"{count:>7} {previous}" if "c" in options else previous)

    async for _, line in lines_of(session, names, problems):
        text = line.rstrip("\n")
        if text == previous:
            count += 1
        else:
            show()
            previous, count = text, 1
    show()
    return 1 if problems else 0


COMMANDS: dict[str, Main] = {
    "echo": echo,
    "printf": printf,
    "grep": grep,
    "head": head,
    "tail": tail,
    "wc": wc,
    "sort": sort,
    "uniq": uniq,
}
