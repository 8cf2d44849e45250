"""The values of `$NAME` and `${…}`: parameters, arrays, and what the operators make of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from day6_core.shell.language.assignments import key_of
from day6_core.shell.language.lexer import single_word
from day6_core.shell.language.patterns import Pattern
from day6_core.shell.language.quoting import array_text, declared, double_quoted, single_quoted
from day6_core.shell.language.refusals import Refused
from day6_core.shell.language.variables import ATTRIBUTES
from day6_core.shell.language.words import SyntaxProblem, Variable, Word, braced, unescaped

if TYPE_CHECKING:
    from day6_core.shell.language.interpreter import Shell
    from day6_core.shell.language.redirection import Streams

_ALL = ("@", "*")


class ExpansionProblem(SyntaxProblem):
    """A word without a value (`$((1/0))`): the rest of the line is not run, and the status is 1."""


class UnboundProblem(ExpansionProblem):
    """`${NAME:?text}`, and a variable that is not set, under `set -u`: these end a shell that nobody types into."""


@dataclass
class Value:
    """What an expansion gives: one text, or with `many` any number of them, which stay apart in quotes unless `star`."""

    texts: list[str]
    many: bool = False
    star: bool = False
    keys: list[str] | None = None
    """Of an array: the keys of the texts."""

    @property
    def text(self) -> str | None:
        return self.texts[0] if self.texts and not self.many else None

    @property
    def is_null(self) -> bool:
        return not any(self.texts)


async def value_of(part: Variable, shell: Shell, streams: Streams) -> Value | Word:
    """Return the value, or the word that is to be expanded in its place. Raises ExpansionProblem."""
    if part.operator == "bad":
        raise ExpansionProblem(f"${{{part.argument}}}: bad substitution")
    if part.prefix == "!":
        if part.operator == "names":
            names = [name for name in shell.variable_names() if name.startswith(part.name)]
            return Value(sorted(names), many=True, star=part.argument == "*")
        if part.subscript in _ALL and not part.operator:
            cell = shell.variables.find(part.name)
            return Value([] if cell is None else cell.keys(), many=True, star=part.subscript == "*")
        part = await _indirect(part, shell, streams)
    value = await _plain(part, shell, streams)
    if part.prefix == "#":
        if value.many:
            return Value([str(len(value.texts))])
        _refuse_unset(part, value, shell)
        return Value([str(len(value.text or ""))])
    operator = part.operator
    if operator.lstrip(":") in ("-", "+", "=", "?") and operator:
        return await _defaulted(value, part, shell, streams)
    _refuse_unset(part, value, shell)
    if operator in ("%", "%%", "#", "##"):
        pattern = await _pattern(part.argument, shell, streams)
        return replace(value, texts=[trimmed(text, operator, pattern) for text in value.texts])
    if operator in ("/", "//"):
        return replace(value, texts=await _replaced(value.texts, part, shell, streams))
    if operator in ("^", "^^", ",", ",,", "~", "~~"):
        pattern = await _pattern(part.argument or "?", shell, streams)
        return replace(value, texts=[_recased(text, operator, pattern) for text in value.texts])
    if operator == ":":
        return await _slice(value, part, shell, streams)
    return _transformed(value, part, shell) if operator == "@" else value


async def _indirect(part: Variable, shell: Shell, streams: Streams) -> Variable:
    """`${!NAME}`: the expansion of what its value names."""
    cell = shell.variables.cells.get(part.name)
    if cell is not None and "n" in cell.attributes:
        return replace(part, name="", operator="named", argument=cell.text or "", prefix="")
    named = (await _plain(replace(part, prefix=""), shell, streams)).text
    if named is None:
        raise ExpansionProblem(f"{part.name}: invalid indirect expansion")
    target = braced(named, part.quoted)
    if target.operator or target.prefix:
        raise ExpansionProblem(f"{named}: invalid variable name")
    return replace(part, name=target.name, subscript=target.subscript, prefix="")


async def _plain(part: Variable, shell: Shell, streams: Streams) -> Value:
    """The value without its operator."""
    if part.operator == "named":
        return Value([part.argument])
    if part.name in _ALL:
        return Value(list(shell.arguments), many=True, star=part.name == "*")
    if part.subscript in _ALL:
        cell = shell.variables.find(part.name)
        if cell is None:
            return Value([], many=True, star=part.subscript == "*")
        return Value(cell.values(), many=True, star=part.subscript == "*", keys=cell.keys())
    if part.subscript is not None:
        key = await key_of(part.name, part.subscript, shell, streams)
        found = shell.variables.element(part.name, key)
        if found is None and shell.variables.is_outside(part.name, key):
            streams.stderr.write(f"{shell.name}: {part.name}: bad array subscript\n")
    else:
        found = shell.parameter(part.name)
    return Value([] if found is None else [found])


def _refuse_unset(part: Variable, value: Value, shell: Shell) -> None:
    if "u" in shell.options and not value.many and not value.texts:
        subscript = "" if part.subscript is None else f"[{part.subscript}]"
        raise UnboundProblem(f"{'$' * part.name.isdigit()}{part.name}{subscript}: unbound variable")


def argument(part: Variable) -> Word:
    """The text after the operator as one word, in which white space does not split."""
    return single_word(part.argument, part.quoted, toggling=True)


async def _pattern(source: str, shell: Shell, streams: Streams) -> Pattern:
    from day6_core.shell.language.expansion import expand_pattern

    extglob = "extglob" in shell.settings
    return await expand_pattern(single_word(source, extglob=extglob), shell, streams, extended=extglob)


async def _defaulted(value: Value, part: Variable, shell: Shell, streams: Streams) -> Value | Word:
    from day6_core.shell.language.expansion import expand_text

    colon, kind = part.operator.startswith(":"), part.operator[-1]
    missing = (not value.texts) or (colon and (value.is_null if value.many else not value.text))
    if value.many and not colon and part.name not in _ALL:
        missing = not value.texts
    if kind == "+":
        return Value([]) if missing else argument(part)
    if not missing:
        return value
    if kind == "-":
        return argument(part)
    default = await expand_text(argument(part), shell, streams)
    subscript = "" if part.subscript is None else f"[{part.subscript}]"
    if kind == "?":
        raise UnboundProblem(f"{part.name}{subscript}: {default or 'parameter ' + 'null or ' * colon + 'not set'}")
    if not (part.name[0].isalpha() or part.name[0] == "_") or part.subscript in _ALL:
        raise ExpansionProblem(f"${part.name}: cannot assign in this way")
    key = None if part.subscript is None else await key_of(part.name, part.subscript, shell, streams)
    shell.variables.assign(part.name, default, key=key)
    return Value([default])


def split_at(text: str, separator: str) -> tuple[str, str | None]:
    """Split at the first separator that is not in quotes, brackets or an expansion; None after it if there is none."""
    depth, at = 0, 0
    choices = 0
    while at < len(text):
        char = text[at]
        if char == "\\":
            at += 1
        elif char in "'\"":
            end = text.find(char, at + 1)
            at = len(text) if end < 0 else end
        elif text.startswith(("${", "$("), at):
            depth += 1
            at += 1
        elif (char in "({" and depth) or (char == "(" and separator == ":"):
            depth += 1
        elif char in ")}" and depth:
            depth -= 1
        elif char == "?" and separator == ":" and not depth:
            choices += 1
        elif char == separator and not depth:
            if not choices:
                return text[:at], text[at + 1 :]
            choices -= 1
        at += 1
    return text, None


async def _slice(value: Value, part: Variable, shell: Shell, streams: Streams) -> Value:
    """`${x:offset:length}`; a negative one counts from the end. Of `$@` and arrays elements are taken, not characters."""
    from day6_core.shell.language.expansion import sum_of

    first, second = split_at(part.argument, ":")
    offset = await sum_of(first, shell, streams)
    length = None if second is None else await sum_of(second, shell, streams)
    if not value.many:
        text = value.text or ""
        start = len(text) + offset if offset < 0 else offset
        if start < 0 or start > len(text):
            return Value([""] if value.texts else [])
        end = len(text) if length is None else len(text) + length if length < 0 else start + length
        if end < start:
            raise ExpansionProblem(f"{second}: substring expression < 0")
        return Value([text[start:end]])
    if length is not None and length < 0:
        raise ExpansionProblem(f"{second}: substring expression < 0")
    texts = value.texts
    if part.name in _ALL:
        texts = [shell.zero, *texts]
        start = len(texts) + offset if offset < 0 else offset
        if offset == 0 and length is None:
            texts = texts if part.argument else value.texts
    elif value.keys is not None and (cell := shell.variables.find(part.name)) is not None and not cell.keyed:
        highest = int(value.keys[-1]) + 1 if value.keys else 0
        offset = highest + offset if offset < 0 else offset
        start = len([key for key in value.keys if int(key) < offset]) if offset >= 0 else -1
    else:
        start = len(texts) + offset if offset < 0 else max(offset - 1, 0) if offset > 0 else 0
    if start < 0:
        return replace(value, texts=[])
    return replace(value, texts=texts[start : None if length is None else start + length])


def trimmed(value: str, operator: str, pattern: Pattern) -> str:
    """`${x%pattern}` and its relatives: cut the shortest or longest matching end or beginning."""
    expression = pattern.expression
    if operator == "##" and pattern.simple:
        match = expression.match(value)
        return value[match.end() :] if match is not None else value
    lengths = range(len(value) + 1)
    for length in lengths if len(operator) == 1 else reversed(lengths):
        if operator[0] == "%" and expression.fullmatch(value, len(value) - length):
            return value[: len(value) - length]
        if operator[0] == "#" and expression.fullmatch(value, 0, length):
            return value[length:]
    return value


async def _replaced(values: list[str], part: Variable, shell: Shell, streams: Streams) -> list[str]:
    """`${x/pattern/text}`: the first match, or each with `//`; a pattern that begins with `#` or `%` matches at that end.

    An unquoted `&` in the text is what was matched.
    """
    from day6_core.shell.language.expansion import pieces_of

    source, text = split_at(part.argument, "/")
    anchor = source[:1] if source[:1] in ("#", "%") and part.operator == "/" else ""
    pattern = await _pattern(source.removeprefix(anchor), shell, streams)
    pieces = await pieces_of(single_word(text or ""), shell, streams)
    if not source.removeprefix(anchor):
        prefix = "".join(piece for piece, _ in pieces)
        return [{"#": prefix + value, "%": value + prefix}.get(anchor, value) for value in values]

    def new(matched: str) -> str:
        return "".join(piece if quoted else _with_match(piece, matched) for piece, quoted in pieces)

    return [_with_replacements(value, pattern, anchor, new, every=part.operator == "//") for value in values]


def _with_match(text: str, matched: str) -> str:
    parts = text.split("\\&")
    return "&".join(part.replace("&", matched) for part in parts)


def _with_replacements(value: str, pattern: Pattern, anchor: str, new: Callable[[str], str], *, every: bool) -> str:
    expression = pattern.expression
    if anchor:
        for length in reversed(range(len(value) + 1)):
            start, end = (0, length) if anchor == "#" else (len(value) - length, len(value))
            if expression.fullmatch(value, start, end):
                return f"{value[:start]}{new(value[start:end])}{value[end:]}"
        return value
    found: list[str] = []
    at = 0
    if not value and expression.fullmatch(value):
        return new("")
    while at < len(value):
        match = expression.search(value, at)
        if match is None:
            break
        if match.end() == match.start():
            found.append(value[at : match.end() + 1])
            at = match.end() + 1
            continue
        found.append(value[at : match.start()] + new(match[0]))
        at = match.end()
        if not every:
            break
    return "".join(found) + value[at:]


def _recased(text: str, operator: str, pattern: Pattern) -> str:
    """`${x^pattern}` and its relatives: change the case of the first character, or of each, if it matches."""
    change = {"^": str.upper, ",": str.lower, "~": str.swapcase}[operator[0]]
    if len(operator) == 1:
        return (change(text[:1]) if pattern.matches(text[:1]) else text[:1]) + text[1:]
    return "".join(change(char) if pattern.matches(char) else char for char in text)


def _transformed(value: Value, part: Variable, shell: Shell) -> Value:
    """`${x@Q}` and its relatives."""
    kind = part.argument
    cell = shell.variables.find(part.name)
    simple: dict[str, Callable[[str], str]] = {
        "Q": single_quoted, "U": str.upper, "L": str.lower, "E": unescaped, "u": lambda text: text[:1].upper() + text[1:],
    }  # fmt: skip
    if kind in simple:
        return replace(value, texts=[simple[kind](text) for text in value.texts])
    if kind == "a":
        flags = "".join(letter for letter in ATTRIBUTES if cell is not None and letter in cell.attributes)
        return replace(value, texts=[flags] * (len(value.texts) if value.many else 1))
    if kind in "Kk" and value.many and cell is not None and cell.items is not None:
        if kind == "K":
            shown = array_text(cell)[1:-1].strip() and " ".join(
                f"{key if not cell.keyed or key.isalnum() else double_quoted(key)} {double_quoted(text)}"
                for key, text in zip(cell.keys(), cell.values(), strict=True)
            )
            return Value([shown + " " * (cell.keyed and bool(shown))])
        pairs = zip(cell.keys(), cell.values(), strict=True)
        return replace(value, texts=[each for pair in pairs for each in pair])
    if kind in "Kk":
        return replace(value, texts=[single_quoted(text) for text in value.texts])
    if kind == "A" and cell is not None and part.name not in _ALL:
        if cell.items is not None and value.many:
            head, value_text = declared(part.name, cell).split("=", 1)
            return replace(value, texts=[*head.split(" ")[:-1], f"{part.name}={value_text}"])
        flags = "".join(letter for letter in ATTRIBUTES if letter in cell.attributes)
        if value.text is None:
            return Value([f"declare -{flags} {part.name}"] if flags else [])
        return Value([f"{f'declare -{flags} ' if flags else ''}{part.name}={single_quoted(value.text)}"])
    if kind == "A" and part.name in _ALL:
        return Value([f"set -- {' '.join(single_quoted(text) for text in value.texts)}"])
    if not value.texts:
        return value
    raise Refused(f"${{{part.name}@{kind}}}")
