"""cut, tr, rev, sed: commands that change lines."""

from __future__ import annotations

import re
from collections.abc import Callable, Generator
from functools import partial

from day6_core.session.session import Session
from day6_core.session.task import in_turns
from day6_core.session.threads import in_thread
from day6_core.shell.builtins.options import UsageError, complain, parse, reason
from day6_core.shell.builtins.text import lines_of, unescape
from day6_core.shell.outside import agreed, keys_of
from day6_core.user_pattern import Match, TooComplex, UserPattern

# -- cut ---------------------------------------------------------------------------------------------------------------


async def cut(session: Session) -> int:
    try:
        options, names = parse(
            session.argv,
            "s",
            "dfc",
            {"--delimiter": "d", "--fields": "f", "--characters": "c", "--only-delimited": "s"},
        )
        if ("f" in options) == ("c" in options):
            wrong = (
                "only one list may be" if "f" in options else "you must specify a list of bytes, characters, or fields"
            )
            wrong = f"{wrong} specified" if "f" in options else wrong
            raise UsageError(f"{wrong}\nTry 'cut --help' for more information.")
        wanted = _ranges(options.get("f") or options["c"])
    except UsageError as error:
        complain(session, error)
        return 1
    delimiter = options.get("d", "\t")
    problems: list[str] = []
    async for _, line in lines_of(session, names, problems):
        text = line.rstrip("\n")
        if "c" in options:
            session.print("".join(character for at, character in enumerate(text, 1) if wanted(at)))
        elif delimiter in text:
            session.print(delimiter.join(field for at, field in enumerate(text.split(delimiter), 1) if wanted(at)))
        elif "s" not in options:
            session.print(text)
    return 1 if problems else 0


def _ranges(text: str) -> Callable[[int], bool]:
    """Read `1,3-5,7-`. Raises UsageError."""
    found: list[tuple[int, float]] = []
    for part in text.split(","):
        match = re.fullmatch(r"(\d*)(-?)(\d*)", part)
        if match is None or part in ("", "-"):
            raise UsageError(f"invalid field value '{part}'\nTry 'cut --help' for more information.")
        first = int(match[1] or 1)
        found.append((first, (float(match[3]) if match[3] else float("inf")) if match[2] else first))
    return lambda number: any(first <= number <= last for first, last in found)


# -- tr ----------------------------------------------------------------------------------------------------------------

_CLASSES = {
    "upper": "ABCDEFGHIJKLMNOPQRSTUVWXYZ",
    "lower": "abcdefghijklmnopqrstuvwxyz",
    "digit": "0123456789",
    "space": " \t\n\r\v\f",
}


_ONE_SET = "\nOnly one string may be given when deleting without squeezing repeats."
_TWO_SETS = "\nTwo strings must be given when "
_SETS = {"": (2, 2, _TWO_SETS + "translating."), "d": (1, 1, _ONE_SET), "s": (1, 2, ""),
         "ds": (2, 2, _TWO_SETS + "both deleting and squeezing repeats.")}  # fmt: skip
"""Options -> the fewest and the most operands of tr, and why."""


async def tr(session: Session) -> int:
    try:
        options, sets = parse(session.argv, "dsc", "", {"--delete": "d", "--squeeze-repeats": "s", "--complement": "c"})
        fewest, most, why = _SETS["".join(sorted({"d", "s"} & set(options)))]
        if not fewest <= len(sets) <= most:
            wrong = f"extra operand ‘{sets[most]}’" if len(sets) > most else "missing operand"
            wrong += f" after ‘{sets[0]}’" if 0 < len(sets) < fewest else ""
            wrong += why if len(sets) in (1, 2) else ""
            raise UsageError(f"{wrong}\nTry 'tr --help' for more information.")
    except UsageError as error:
        complain(session, error)
        return 1
    first = _set(sets[0])
    second = _set(sets[1]) if len(sets) > 1 else ""
    inverted = "c" in options

    def chosen(character: str) -> bool:
        return (character in first) != inverted

    def changed(character: str) -> str:
        if not chosen(character):
            return character
        if "d" in options:
            return ""
        if not second:
            return character
        at = len(second) - 1 if inverted else min(first.index(character), len(second) - 1)
        return second[at]

    squeezed = second or first
    last = ""
    async for _, line in lines_of(session, [], []):
        text = ""
        for character in "".join(map(changed, line)):
            if "s" not in options or character != last or character not in squeezed:
                text += character
            last = character
        session.stdout.write(text)
    return 0


def _set(text: str) -> str:
    """Read `a-z`, `[:upper:]`, `\\n`."""
    text = re.sub(r"\[:(\w+):\]", lambda match: _CLASSES.get(match[1], ""), unescape(text))
    return re.sub(
        r"(.)-(.)", lambda match: "".join(map(chr, range(ord(match[1]), ord(match[2]) + 1))), text, flags=re.DOTALL
    )


# -- rev ---------------------------------------------------------------------------------------------------------------

_NOT_UTF_8 = re.compile("[\udc80-\udcff]")


async def rev(session: Session) -> int:
    """util-linux's: unlike coreutils' tools it takes `-` for a file, and it stops at anything that is not text."""
    try:
        _, names = parse(session.argv)
    except UsageError as error:
        complain(session, error)
        return 1
    problems: list[str] = []
    inputs: list[str | None] = [*names] or [None]
    for name in inputs:
        if name is not None and (session.cwd / name).is_dir():
            complain(session, f"{name}: 0: Is a directory")
            problems.append(name)
        else:
            await _reverse(session, name, problems)
    return 1 if problems else 0


async def _reverse(session: Session, name: str | None, problems: list[str]) -> None:
    """Print the lines of a file, of standard input for None, from their ends to their beginnings."""
    shown = "stdin" if name is None else name
    places = [] if name is None else ["./-" if name == "-" else name]
    refusal = f"cannot open {shown.replace('{', '{{').replace('}', '}}')}: {{reason}}"
    number = 0
    async for _, line in lines_of(session, places, problems, refusal):
        text = line.removesuffix("\n")
        if _NOT_UTF_8.search(text):
            complain(session, f"{shown}: {number}: Invalid or incomplete multibyte or wide character")
            problems.append(shown)
            return
        session.stdout.write(text[::-1] + line[len(text) :])
        number += 1


# -- sed ---------------------------------------------------------------------------------------------------------------


async def sed(session: Session) -> int:
    """`s/A/B/`, with g, I, p and a number, `Np`, `Nd`, `/A/d`, `/A/p`, `$`, ranges `N,M`; -n, -i, -E, -e."""
    try:
        options, names = parse(
            session.argv,
            "nEri",
            "e",
            {"--in-place": "i", "--quiet": "n", "--silent": "n", "--regexp-extended": "E"},
            "e",
        )
    except UsageError as error:
        complain(session, error)
        return 1
    script = options.get("e")
    if script is None:
        if not names:
            session.print_error("Usage: sed [OPTION]... {script-only-if-no-other-script} [input-file]...")
            return 1
        script = names.pop(0)
    extended = bool({"E", "r"} & set(options))
    try:
        steps = [
            _Step(part.strip(), extended) for part in re.split(r"(?<!\\);(?![^/]*/[^/]*$)|\n", script) if part.strip()
        ]
    except (ValueError, re.error) as error:
        complain(session, f"-e expression #1, char {len(script)}: {error}")
        return 1
    if "i" in options:
        keys = keys_of(session.stdin, session.stdout, session.stderr)
        paths = [session.cwd / name for name in names]
        if not await agreed(session.name, paths, keys, session.stderr, session.env):
            return 1
        return await _in_place(session, names, steps, "n" in options)
    problems: list[str] = []
    lines = [line async for _, line in lines_of(session, names, problems, "can't read {name}: {reason}")]
    try:
        session.stdout.write("".join(await _edited(lines, steps, "n" in options)))
    except TooComplex as error:
        complain(session, str(error))
        return 1
    return 2 if problems else 0


async def _in_place(session: Session, names: list[str], steps: list[_Step], silent: bool) -> int:
    """Edit the files in place, each completely or not at all. Returns sed's status: 4 if a file could not be written."""
    from day6_core.whole_file import replace_file

    status = 0
    for name in names:
        path = session.cwd / name
        if path.exists() and not path.is_file():
            complain(session, f"couldn't edit {name}: not a regular file")
            return 4
        try:
            text = path.read_bytes().decode("utf-8", "surrogateescape")
            lines = [line + "\n" for line in text.split("\n")]
            lines[-1] = lines[-1][:-1]  # where the last line has no end
            lines = lines if lines[-1] else lines[:-1]
        except OSError as error:
            complain(session, f"can't read {name}: {reason(error)}")
            status = status or 2
            continue
        try:
            edited = "".join(await _edited(lines, steps, silent)).encode("utf-8", "surrogateescape")
            await in_thread(partial(replace_file, path, edited, follow=False))
        except TooComplex as error:
            complain(session, str(error))
            return 1
        except OSError as error:
            complain(session, f"couldn't flush {name}: {reason(error)}")
            return 4
    return status


async def _edited(lines: list[str], steps: list[_Step], silent: bool) -> list[str]:
    out = []
    for number, line in enumerate(lines, 1):
        text, end = line.rstrip("\n"), "\n" if line.endswith("\n") else ""
        deleted = False
        for step in steps:
            if not await step.applies(number, text, number == len(lines)):
                continue
            if step.action == "d":
                deleted = True
                break
            if step.action == "p":
                out.append(text + "\n")
            else:
                text, done = await in_turns(step.substitute(text))
                if done and step.prints:
                    out.append(text + "\n")
        if not deleted and not silent:
            out.append(text + end)
    return out


class _Step:
    """One command of a script."""

    _FORM = re.compile(r"(?:(?P<from>\d+|\$|/(?:[^/\\]|\\.)*/)(?:,(?P<to>\d+|\$))?)?\s*(?P<rest>[pds].*)", re.DOTALL)

    def __init__(self, text: str, extended: bool) -> None:
        match = self._FORM.fullmatch(text)
        if match is None:
            raise ValueError(f"unknown command: `{text[:1]}'")
        self._from, self._to = match["from"], match["to"]
        self._lines = _pattern(self._from[1:-1], extended, 0) if self._from and self._from[0] == "/" else None
        self.action = match["rest"][0]
        if self.action != "s":
            if len(match["rest"]) > 1:
                raise ValueError("extra characters after command")
            return
        mark = match["rest"][1:2]
        parts = _split_at(mark, match["rest"][2:]) if mark else []
        if len(parts) != 3:
            raise ValueError("unterminated `s' command")
        flags = re.fullmatch(r"(?P<words>[gIip]*)(?P<number>[1-9]\d*)?(?P<more>[gIip]*)", parts[2])
        if flags is None:
            raise ValueError("unknown option to `s'")
        words = flags["words"] + flags["more"]
        self._first = int(flags["number"] or 1)
        self._last = 0 if "g" in words else self._first
        self.prints = "p" in words
        self._what = _pattern(
            parts[0].replace("\\" + mark, mark), extended, re.IGNORECASE if set("Ii") & set(words) else 0
        )
        self._by = parts[1].replace("\\" + mark, mark)
        _check_replacement(self._by, self._what.groups)

    async def applies(self, number: int, text: str, last: bool) -> bool:
        """Whether the command's address matches this line."""
        if self._lines is not None:
            return await in_turns(self._lines.searching(text)) is not None
        if self._from is None:
            return True
        first = last if self._from == "$" else number >= int(self._from)
        if self._to is None:
            return last if self._from == "$" else number == int(self._from)
        return first and (self._to == "$" or number <= int(self._to))

    def substitute(self, text: str) -> Generator[None, None, tuple[str, bool]]:
        """Return the line with its matches replaced, and whether any was."""
        number = 0

        def replaced(found: Match) -> str:
            nonlocal number
            number += 1
            return _replacement(self._by, found) if number >= self._first else found[0] or ""

        return (yield from self._what.replacing(text, replaced, self._last)), number >= self._first


def _split_at(mark: str, text: str) -> list[str]:
    """Split at a delimiter that no backslash escapes."""
    parts, start = [], 0
    for found in re.finditer(rf"\\.|{re.escape(mark)}", text, re.DOTALL):
        if found[0] == mark:
            parts.append(text[start : found.start()])
            start = found.end()
    return [*parts, text[start:]]


_IN_REPLACEMENT = re.compile(r"\\(?P<group>\d)|\\(?P<letter>.)|&", re.DOTALL)
_LETTERS = {"n": "\n", "t": "\t"}


def _check_replacement(by: str, groups: int) -> None:
    """Raises ValueError with sed's text."""
    for match in _IN_REPLACEMENT.finditer(by):
        if match["group"] and int(match["group"]) > groups:
            raise ValueError(f"invalid reference {match[0]} on `s' command's RHS")


def _replacement(by: str, found: Match) -> str:
    r"""Return what replaces a match: `&` and `\0` are the whole match, `\1` its first group."""

    def meaning(match: re.Match[str]) -> str:
        if match["letter"]:
            return _LETTERS.get(match["letter"], match["letter"])
        return found[int(match["group"] or 0)] or ""

    return _IN_REPLACEMENT.sub(meaning, by)


def _pattern(text: str, extended: bool, flags: int) -> UserPattern:
    if not extended:
        text = re.sub(r"\\([|(){}+?])|([|(){}+?])", lambda m: m[1] if m[1] else "\\" + m[2], text)
    return UserPattern(text, flags)
