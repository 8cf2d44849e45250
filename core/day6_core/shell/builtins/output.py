"""echo and printf."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from datetime import datetime, tzinfo

from day6_core.session.session import Session
from day6_core.shell.builtins.options import complain_as_shell
from day6_core.shell.byte_text import joined, of_byte, of_code
from day6_core.shell.language.assignments import key_of, split_target
from day6_core.shell.language.interpreter import shell_of
from day6_core.shell.language.quoting import backslashed
from day6_core.shell.language.words import SyntaxProblem

LONGEST_TEXT = 64 * 1024 * 1024
"""Characters of one field; a shell on a machine this small would not get more memory either."""

_ESCAPES = {
    "n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "e": "\x1b", "E": "\x1b", "f": "\f", "v": "\v", "\\": "\\",
}  # fmt: skip
_HEX = r"x[0-9a-fA-F]{1,2}|u[0-9a-fA-F]{1,4}|U[0-9a-fA-F]{1,8}"
_OF_ECHO = re.compile(rf"\\(0[0-7]{{0,3}}|{_HEX}|c|.)", re.DOTALL)
_OF_FORMAT = re.compile(rf"\\([0-7]{{1,3}}|{_HEX}|.)", re.DOTALL)
_OF_B = re.compile(rf"\\(0?[0-7]{{1,3}}|{_HEX}|c|.)", re.DOTALL)


class _Stop(Exception):
    """`\\c`: nothing more is printed; `text` came before it."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.text = text


def _unescaped(pattern: re.Pattern[str], text: str, more: str = "") -> str:
    """Resolve backslash escapes; an unknown one is kept. Raises _Stop."""
    found: list[str] = []
    at = 0
    for match in pattern.finditer(text):
        found.append(text[at : match.start()])
        at = match.end()
        code = match[1]
        if code == "c" and pattern is not _OF_FORMAT:
            raise _Stop(joined("".join(found)))
        found.append(_character(code, match[0], more))
    return joined("".join([*found, text[at:]]))


def _character(code: str, whole: str, more: str) -> str:
    if code[0] in "01234567":
        return of_byte(int(code, 8) & 0xFF)
    if code[0] == "x" and len(code) > 1:
        return of_byte(int(code[1:], 16))
    if code[0] in "uU" and len(code) > 1:
        return of_code(int(code[1:], 16))
    return code if code in more else _ESCAPES.get(code, whole)


async def echo(session: Session) -> int:
    """`echo [-neE] …`."""
    words = session.argv[1:]
    newline, escapes = True, "xpg_echo" in shell_of(session).settings
    while words and re.fullmatch(r"-[neE]+", words[0]):
        for letter in words.pop(0)[1:]:
            newline = newline and letter != "n"
            escapes = {"e": True, "E": False}.get(letter, escapes)
    text = " ".join(words)
    if escapes:
        try:
            text = _unescaped(_OF_ECHO, text)
        except _Stop as stop:
            text, newline = stop.text, False
    session.print(text, end="\n" if newline else "")
    return 0


async def printf(session: Session) -> int:
    """`printf [-v NAME] FORMAT …`."""
    words = session.argv[1:]
    name = None
    if words[:1] == ["-v"] and len(words) > 1:
        name, words = words[1], words[2:]
        if split_target(f"{name}=") is None:
            complain_as_shell(session, f"`{name}': not a valid identifier")
            return 2
    if words[:1] == ["--"]:
        words = words[1:]
    elif words and words[0].startswith("-") and len(words[0]) > 1:
        complain_as_shell(session, f"{words[0][:2]}: invalid option")
        words = []
    if not words:
        session.print_error(f"{session.name}: usage: printf [-v var] format [arguments]")
        return 2
    run = _Format(words[0], words[1:], _zone(session), lambda text: complain_as_shell(session, text))
    try:
        text = run.text()
    except MemoryError:  # the real one prints the same if there is no memory for such a wide number
        complain_as_shell(session, "write error: Cannot allocate memory")
        return 1
    if name is None:
        session.stdout.write(text)
        return run.status
    shell = shell_of(session)
    target = split_target(f"{name}=")
    assert target is not None
    try:
        key = None if target[1] is None else await key_of(target[0], target[1], shell, shell.all_streams(session))
        shell.variables.assign(target[0], text, key=key)
    except SyntaxProblem as problem:
        complain_as_shell(session, problem)
        return 1
    return run.status


def _zone(session: Session) -> tzinfo | None:
    """The time zone of TZ; None for the machine's."""
    from zoneinfo import ZoneInfo

    name = shell_of(session).variables.get("TZ", "")
    try:
        return ZoneInfo(name) if name else datetime.now().astimezone().tzinfo
    except (KeyError, ValueError, OSError):
        return datetime.now().astimezone().tzinfo


_DIRECTIVE = re.compile(r"%([-+ #0']*)(\*|-?\d+)?(?:\.(\*|-?\d*))?(?:hh|h|ll|l|L|j|z|t)?(\([^)]*\)T|.|$)", re.DOTALL)


class _Format:
    """One printf: the format is used as often as there are arguments."""

    def __init__(self, form: str, values: list[str], zone: tzinfo | None, complain: Callable[[str], None]) -> None:
        self.zone = zone
        self.form = form
        self.values = values
        self.complain = complain
        self.status = 0

    def text(self) -> str:
        found: list[str] = []
        try:
            while True:
                before = len(self.values)
                self._once(found)
                if not self.values or len(self.values) == before:
                    break
        except _Stop as stop:
            found.append(stop.text)
        return "".join(found)

    def _once(self, found: list[str]) -> None:
        at = 0
        form = self.form
        while at < len(form):
            start = form.find("%", at)
            found.append(_unescaped(_OF_FORMAT, form[at : start if start >= 0 else None], "'\"?"))
            if start < 0:
                return
            if form.startswith("%%", start):
                found.append("%")
                at = start + 2
                continue
            match = _DIRECTIVE.match(form, start)
            assert match is not None
            at = match.end()
            found.append(self._field(match))

    def _next(self) -> str | None:
        return self.values.pop(0) if self.values else None

    def _field(self, match: re.Match[str]) -> str:
        flags = match[1] or ""
        width = self._whole(self._next() or "0") if match[2] == "*" else int(match[2] or 0)
        precision = None
        if match[3] is not None:
            precision = self._whole(self._next() or "0") if match[3] == "*" else int(match[3] or 0)
        if width < 0:
            flags, width = flags + "-", -width
        if precision is not None and precision < 0:
            precision = None
        if max(width, precision or 0) > LONGEST_TEXT:
            raise MemoryError
        kind = match[4]
        if kind.endswith("T"):
            return _padded(self._time(kind[1:-2]), flags, width, precision)
        if kind in ("s", "b", "q", "Q", "c"):
            return self._words(kind, flags, width, precision)
        if kind in ("d", "i", "o", "u", "x", "X"):
            return _integer(self._whole(self._next() or "0"), kind, flags, width, precision)
        if kind and kind in "eEfFgGaA":
            return self._real(kind, flags, width, precision)
        self.status = 1
        self.complain(
            f"`{kind or '%'}': invalid format character" if kind else f"`{match[0]}': missing format character"
        )
        raise _Stop("")

    def _words(self, kind: str, flags: str, width: int, precision: int | None) -> str:
        value = self._next() or ""
        if kind == "b":
            try:
                value = _unescaped(_OF_B, value)
            except _Stop as stop:
                raise _Stop(_padded(stop.text, flags, width, precision)) from None
        elif kind in "qQ":
            value = backslashed(value)
        elif kind == "c":
            value = value[:1]
        return _padded(value, flags, width, precision)

    def _time(self, form: str) -> str:
        value = self._next()
        seconds = time.time() if value is None or value in ("-1", "-2") else float(self._whole(value))
        return datetime.fromtimestamp(seconds, self.zone).strftime(form or "%X")

    def _whole(self, text: str) -> int:
        """The value of an integer argument, as far as it is one."""
        if text[:1] in ("'", '"') and text:
            return ord(text[1]) if len(text) > 1 else 0
        stripped = text.lstrip(" \t\n")
        match = re.match(r"([-+]?)(0[xX][0-9a-fA-F]+|0[0-7]*|[1-9]\d*)", stripped)
        if match is None:
            if text:
                self._wrong(text)
            return 0
        digits = match[2]
        base = 16 if digits[:2] in ("0x", "0X") else 8 if digits.startswith("0") else 10
        value = int(digits, base) * (-1 if match[1] == "-" else 1)
        if match.end() != len(stripped):
            self._wrong(text)
        limit = 2**63
        if not -limit <= value < limit:
            self.complain(f"warning: {text}: Numerical result out of range")
            value = max(min(value, limit - 1), -limit)
        return value

    def _wrong(self, text: str) -> None:
        octal = bool(re.match(r"[-+]?0\d", text))
        self.complain(f"{text}: invalid {'octal ' * octal}number")
        self.status = 1

    def _real(self, kind: str, flags: str, width: int, precision: int | None) -> str:
        text = self._next() or "0"
        if text[:1] in ("'", '"'):
            value = float(ord(text[1])) if len(text) > 1 else 0.0
        else:
            match = re.match(
                r"\s*[-+]?(0[xX][0-9a-fA-F]+|inf(inity)?|nan|(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?)", text, re.IGNORECASE
            )
            if match is None or match.end() != len(text):
                self._wrong(text)
            found = match[0].strip() if match is not None else "0"
            value = float(int(found, 16)) if "x" in found.lower() else float(found)
        flags = flags.replace("'", "")
        point = "" if precision is None else f".{precision}"
        return f"%{flags}{width or ''}{point}{kind}" % value


def _integer(value: int, kind: str, flags: str, width: int, precision: int | None) -> str:
    if kind in "ouxX" and value < 0:
        value += 2**64
    digits = {"o": f"{abs(value):o}", "x": f"{abs(value):x}", "X": f"{abs(value):X}"}.get(kind, str(abs(value)))
    if precision is not None:
        digits = "" if not precision and not value else digits.rjust(precision, "0")
    mark = ""
    if "#" in flags and value:
        mark = {"o": "" if digits.startswith("0") else "0", "x": "0x", "X": "0X"}.get(kind, "")
    sign = ""
    if kind in "di":
        sign = "-" if value < 0 else "+" if "+" in flags else " " if " " in flags else ""
    head = sign + mark
    if "0" in flags and "-" not in flags and precision is None:
        digits = digits.rjust(width - len(head), "0")
    text = head + digits
    return text.ljust(width) if "-" in flags else text.rjust(width)


def _padded(text: str, flags: str, width: int, precision: int | None) -> str:
    """Width and precision count bytes, as in C."""
    if precision is not None:
        data = text.encode("utf-8", "surrogateescape")[:precision]
        text = joined(data.decode("utf-8", "surrogateescape"))
    room = width - len(text.encode("utf-8", "surrogateescape"))
    return text + " " * room if "-" in flags else " " * room + text
