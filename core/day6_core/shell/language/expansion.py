"""From the words of a command line to its arguments: `~`, variables, `$(…)`, `$((…))`, splitting, file name patterns, quotes."""

from __future__ import annotations

import fnmatch
import glob
import itertools
import re
import threading
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.session.threads import in_thread
from day6_core.shell.language.arithmetic import ArithmeticProblem, evaluate
from day6_core.shell.language.lexer import single_word
from day6_core.shell.language.words import Part, Substitution, SyntaxProblem, Text, Variable, Word

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams

_PATTERN = frozenset("*?[")
_CLASSES = {"alpha": "A-Za-z", "digit": "0-9", "alnum": "A-Za-z0-9", "upper": "A-Z", "lower": "a-z", "space": r"\s"}
"""Of regular expressions and patterns: `[[:digit:]]`."""

_NAMED = re.compile(r"[A-Za-z_]\w*\+?=")
"""What makes an argument look like an assignment: bash looks for `~` in its value, as in `export A=~/a` so in `echo A=~/a`."""

MOST_WORDS = 1_000_000
"""Most words of a brace expansion; the real shell uses up all memory for more."""


class ExpansionProblem(SyntaxProblem):
    """A word without a value (`$((1/0))`): the rest of the line is not run, and the status is 1."""


class UnboundProblem(ExpansionProblem):
    """`${NAME:?text}`, and a variable that is not set, under `set -u`: these end a shell that nobody types into."""


class _Fields:
    """Arguments being put together: each is a list of (text, quoted) pieces."""

    def __init__(self) -> None:
        self.done: list[list[tuple[str, bool]]] = []
        self._open: list[tuple[str, bool]] | None = None

    def add(self, text: str, quoted: bool) -> None:
        if self._open is None:
            if not text and not quoted:
                return
            self._open = []
        self._open.append((text, quoted))

    def end(self) -> None:
        if self._open is not None:
            self.done.append(self._open)
            self._open = None

    def add_split(self, text: str) -> None:
        """Add unquoted text from an expansion: white space in it separates arguments."""
        if not text:
            return
        if text[0].isspace():
            self.end()
        for number, piece in enumerate(text.split()):
            if number:
                self.end()
            self.add(piece, False)
        if text[-1].isspace():
            self.end()


async def expand(words: list[Word], shell: Shell, streams: Streams) -> list[str]:
    """Return the arguments that `words` expand to."""
    arguments: list[str] = []
    for word in words:
        for single in _braces(word):
            fields = _Fields()
            for part in _tilde(single.parts, shell, argument=True):
                if isinstance(part, Text):
                    fields.add(part.text, part.quoted)
                elif isinstance(part, Variable) and part.name in "@*" and not part.operator:
                    if part.quoted and part.name == "*":
                        fields.add(" ".join(shell.arguments), True)
                        continue
                    for number, value in enumerate(shell.arguments):
                        if number:
                            fields.end()
                        if part.quoted:
                            fields.add(value, True)
                        else:
                            fields.add_split(value)
                else:
                    value = await _value(part, shell, streams)
                    if part.quoted:
                        fields.add(value, True)
                    else:
                        fields.add_split(value)
            fields.end()
            for pieces in fields.done:
                found = await _files(pieces, shell.cwd) if "f" not in shell.options else None
                if found or (found is not None and "nullglob" in shell.settings):
                    arguments.extend(found)
                else:
                    arguments.append("".join(text for text, _ in pieces))
    return arguments


async def expand_text(word: Word, shell: Shell, streams: Streams, *, assigned: bool = False) -> str:
    """Expand `word` to one text: no splitting, no patterns (assignments, redirections, here-documents)."""
    result = []
    for part in _tildes_of_value(word.parts, shell) if assigned else _tilde(word.parts, shell):
        if isinstance(part, Text):
            result.append(part.text)
        elif isinstance(part, Variable) and part.name in "@*" and not part.operator:
            result.append(" ".join(shell.arguments))
        else:
            result.append(await _value(part, shell, streams))
    return "".join(result)


def _tilde(parts: tuple[Part, ...], shell: Shell, *, argument: bool = False) -> tuple[Part, ...]:
    first = parts[0] if parts else None
    if not isinstance(first, Text) or first.quoted:
        return parts
    if argument and (name := _NAMED.match(first.text)):
        return (Text(name[0]), *_tildes_of_value((Text(first.text[name.end() :]), *parts[1:]), shell))
    if not first.text.startswith("~"):
        return parts
    user, slash, rest = first.text[1:].partition("/")
    if user not in ("", shell.desk.user) or (not slash and len(parts) > 1):
        return parts
    home = shell.variables.get("HOME", "~")
    return (Text(home, quoted=True), Text(slash + rest), *parts[1:])


def _tildes_of_value(parts: tuple[Part, ...], shell: Shell) -> tuple[Part, ...]:
    """Expand tildes in a value that is assigned: at its beginning and after each colon (`PATH=$PATH:~/bin`)."""
    found: list[Part] = []
    begins = True
    for number, part in enumerate(parts):
        if not isinstance(part, Text) or part.quoted:
            found.append(part)
            begins = False
            continue
        pieces = part.text.split(":")
        for at, piece in enumerate(pieces):
            if at:
                found.append(Text(":"))
                begins = True
            rest = parts[number + 1 :] if at == len(pieces) - 1 else ()
            head = _tilde((Text(piece), *rest), shell) if begins else (Text(piece), *rest)
            found.extend(head[: len(head) - len(rest)])
            begins = begins and not piece
    return tuple(found)


async def _value(part: Variable | Substitution, shell: Shell, streams: Streams) -> str:
    if isinstance(part, Substitution):
        if part.arithmetic:
            return str(await sum_of(part.source, shell, streams))
        return await shell.output_of(part.source, streams)
    value = shell.parameter(part.name)
    if part.operator:
        return await _changed(value, part, shell, streams)
    if value is None and "u" in shell.options and not part.name.startswith(("@", "*")):
        raise UnboundProblem(f"{part.name}: unbound variable")
    return value or ""


async def _changed(value: str | None, part: Variable, shell: Shell, streams: Streams) -> str:
    """`${NAME…}` with an operator."""
    operator = part.operator
    if operator == "#" and not part.argument:
        return str(len(shell.arguments if part.name in "@*" else value or ""))
    if operator == "!":
        return shell.parameter(value or "") or ""
    if operator in ("%", "%%", "#", "##"):
        return _trim(value or "", operator, await expand_pattern(single_word(part.argument), shell, streams))
    if operator in ("/", "//"):
        return await _replaced(value or "", part, shell, streams)
    if operator in ("^", "^^", ",", ",,"):
        change = str.upper if operator[0] == "^" else str.lower
        text = value or ""
        return change(text) if len(operator) == 2 else change(text[:1]) + text[1:]
    if operator == ":":
        return await _slice(value or "", part, shell, streams)
    missing = value is None or (operator.startswith(":") and not value)
    if operator in (":+", "+"):
        return "" if missing else await expand_text(_argument(part), shell, streams)
    if not missing:
        return value or ""
    default = await expand_text(_argument(part), shell, streams)
    if operator in (":?", "?"):
        raise UnboundProblem(f"{part.name}: {default or 'parameter null or not set'}")
    if operator in (":=", "="):
        shell.variables[part.name] = default
    return default


async def _slice(value: str, part: Variable, shell: Shell, streams: Streams) -> str:
    """`${x:offset:length}`; a negative one counts from the end."""
    first, colon, second = part.argument.partition(":")
    start = await sum_of(first, shell, streams)
    start = len(value) + start if start < 0 else start
    if start < 0:
        return ""
    if not colon:
        return value[start:]
    length = await sum_of(second, shell, streams)
    return value[start : len(value) + length if length < 0 else start + length]


async def _replaced(value: str, part: Variable, shell: Shell, streams: Streams) -> str:
    """`${x/pattern/text}`: the first match, or each with `//`; a pattern that begins with `#` or `%` matches at that end."""
    source, _, text = part.argument.partition("/")
    anchor = source[:1] if source[:1] in ("#", "%") and part.operator == "/" else ""
    pattern = await expand_pattern(single_word(source.removeprefix(anchor)), shell, streams)
    new = await expand_text(single_word(text, part.quoted), shell, streams)
    if not pattern:
        return value
    regular = fnmatch.translate(pattern).removesuffix(r"\Z").removesuffix(r"\z")
    regular = {"#": r"\A" + regular, "%": regular + r"\Z"}.get(anchor, regular)
    return re.sub(regular, lambda match: new, value, count=0 if part.operator == "//" else 1)


async def sum_of(source: str, shell: Shell, streams: Streams) -> int:
    """The value of `$((source))`. Raises ExpansionProblem with bash's text."""
    text = await expand_text(single_word(source, quoted=True), shell, streams)
    try:
        return evaluate(text, shell.variables)
    except ArithmeticProblem as problem:
        raise ExpansionProblem(str(problem)) from None


async def expand_pattern(word: Word, shell: Shell, streams: Streams) -> str:
    """Return a word as a pattern for fnmatch: quoted text is literal."""
    return "".join([_literal(text) if quoted else _named(text) for text, quoted in await _pieces(word, shell, streams)])


async def expand_regular(word: Word, shell: Shell, streams: Streams) -> str:
    """Return a word as a regular expression: quoted text is literal."""
    found = "".join([re.escape(text) if quoted else text for text, quoted in await _pieces(word, shell, streams)])
    for name, characters in _CLASSES.items():
        found = found.replace(f"[:{name}:]", characters)
    return found


async def _pieces(word: Word, shell: Shell, streams: Streams) -> list[tuple[str, bool]]:
    parts = _tilde(word.parts, shell)
    return [(await expand_text(Word((part,), ""), shell, streams), part.quoted) for part in parts]


def _named(text: str) -> str:
    """Replace `[:digit:]` and the like in a pattern by the characters they mean."""
    for name, characters in _CLASSES.items():
        text = text.replace(f"[:{name}:]", characters.replace(r"\s", " \t\n\r\v\f"))
    return text


def _literal(text: str) -> str:
    return re.sub(r"([*?[])", r"[\1]", text)


def _argument(part: Variable) -> Word:
    """The text after the operator, as one word: white space in it does not split it."""
    return single_word(part.argument, part.quoted)


def _trim(value: str, operator: str, pattern: str) -> str:
    """`${x%pattern}` and its relatives: cut the shortest or longest matching end or beginning."""
    lengths = range(len(value) + 1)
    cuts = lengths if len(operator) == 1 else reversed(lengths)
    for length in cuts:
        if operator[0] == "%" and fnmatch.fnmatchcase(value[len(value) - length :], pattern):
            return value[: len(value) - length]
        if operator[0] == "#" and fnmatch.fnmatchcase(value[:length], pattern):
            return value[length:]
    return value


async def _files(pieces: list[tuple[str, bool]], cwd: Path) -> list[str] | None:
    """Return the file names that a pattern matches; None for a text that isn't a pattern."""
    if not any(not quoted and _PATTERN.intersection(piece) for piece, quoted in pieces):
        return None
    pattern = "".join(glob.escape(piece) if quoted else piece for piece, quoted in pieces)
    if not _PATTERN.intersection(pattern.rpartition("/")[0]):
        return sorted(glob.glob(pattern, root_dir=cwd))
    abandoned = threading.Event()  # folders of any number: others go on, and Ctrl-C ends it

    def found() -> list[str]:
        wanted = itertools.takewhile(lambda _: not abandoned.is_set(), glob.iglob(pattern, root_dir=cwd))
        return sorted(itertools.islice(wanted, MOST_WORDS))

    try:
        return await in_thread(found)
    finally:
        abandoned.set()


def _braces(word: Word) -> list[Word]:
    """Expand `a{b,c}` and `{1..3}` if the braces are in one unquoted piece; return every other word as it is."""
    for index, part in enumerate(word.parts):
        if isinstance(part, Text) and not part.quoted and "{" in part.text:
            if _brace_count(part.text) > MOST_WORDS:
                raise ExpansionProblem("brace expansion: cannot allocate memory")
            texts = _brace_texts(part.text)
            if texts != [part.text]:
                before, after = word.parts[:index], word.parts[index + 1 :]
                return [replace(word, parts=(*before, Text(text), *after)) for text in texts]
    return [word]


def _brace_count(text: str) -> int:
    """An upper bound of the words that a text's braces expand to: adjacent braces multiply, commas add."""
    numbers = 1
    for inside in re.findall(r"\{([^{}]*)\}", text):
        numbers *= len(_brace_range(inside)) or inside.count(",") + 1
    return numbers


def _brace_texts(text: str) -> list[str]:
    start = text.find("{")
    while start >= 0:
        depth, commas = 0, []
        for at in range(start, len(text)):
            if text[at] == "{":
                depth += 1
            elif text[at] == "," and depth == 1:
                commas.append(at)
            elif text[at] == "}":
                depth -= 1
                if depth == 0:
                    break
        else:
            return [text]
        inside = text[start + 1 : at]
        if commas:
            bounds = [start, *commas, at]
            choices = [text[a + 1 : b] for a, b in itertools.pairwise(bounds)]
            inner = [expanded for choice in choices for expanded in _brace_texts(choice)]
        else:
            inner = _brace_range(inside)
        if inner:
            return [text[:start] + choice + rest for choice in inner for rest in _brace_texts(text[at + 1 :])]
        start = text.find("{", start + 1)
    return [text]


def _brace_range(inside: str) -> list[str]:
    first, dots, last = inside.partition("..")
    last, _, step_text = last.partition("..")
    if not dots:
        return []
    try:
        low, high, step = int(first), int(last), abs(int(step_text or "1")) or 1
    except ValueError:
        if len(first) == len(last) == 1 and (first + last).isalpha() and re.fullmatch(r"-?\d+", step_text or "1"):
            way = 1 if first <= last else -1
            return [chr(code) for code in range(ord(first), ord(last) + way, way * (abs(int(step_text or "1")) or 1))]
        return []
    if abs(high - low) > 10_000:
        return []
    width = (
        max(len(first), len(last))
        if any(end.lstrip("-").startswith("0") and len(end) > 1 for end in (first, last))
        else 0
    )
    numbers = range(low, high + 1, step) if low <= high else range(low, high - 1, -step)
    return [f"{number:0{width}}" for number in numbers]
