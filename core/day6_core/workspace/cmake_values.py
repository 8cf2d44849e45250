"""The commands of CMake that work out values: `string`, `list`, `math`, `file`, and those for file names and arguments.

Each is called with its words, with the variables that it changes and with the folder to which its file names are relative.
Source: the manual pages of the commands.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path

from day6_core.user_pattern import Match, user_pattern

Variables = dict[str, str]
ValueCommand = Callable[[list[str], Variables, Path], None]

_MOST_FILE = 1_000_000
"""Bytes that are read of a file."""


def items_of(text: str) -> list[str]:
    """Return the items of a list."""
    return [item for item in text.split(";") if item]


def _option(words: list[str], variables: Variables, folder: Path) -> None:
    if words:
        variables.setdefault(words[0], words[2] if len(words) > 2 else "OFF")


def _unset(words: list[str], variables: Variables, folder: Path) -> None:
    for name in words[:1]:
        variables.pop(name, None)


# -- lists -------------------------------------------------------------------------------------------------------------


def _list(words: list[str], variables: Variables, folder: Path) -> None:
    if len(words) < 2:
        return
    verb, name, *values = words
    items = items_of(variables.get(name, ""))
    if verb in _LIST_QUESTIONS:
        if values:
            variables[values[-1]] = _LIST_QUESTIONS[verb](items, values[:-1])
    elif verb in ("POP_BACK", "POP_FRONT"):
        for target in values or [""]:
            taken = items.pop(-1 if verb == "POP_BACK" else 0) if items else ""
            if target:
                variables[target] = taken
        variables[name] = ";".join(items)
    elif verb in _LIST_CHANGES:
        variables[name] = ";".join(_LIST_CHANGES[verb](items, values))


def _at(items: list[str], position: str) -> str:
    try:
        return items[int(position)]
    except (IndexError, ValueError):
        return "NOTFOUND"


def _number(text: str, otherwise: int = 0) -> int:
    try:
        return int(text)
    except ValueError:
        return otherwise


def _part(whole: str | list[str], words: list[str]) -> str | list[str]:
    start, length = (_number(word) for word in [*words, "0", "-1"][:2])
    return whole[start:] if length < 0 else whole[start : start + length]


_LIST_QUESTIONS: dict[str, Callable[[list[str], list[str]], str]] = {
    "LENGTH": lambda items, words: str(len(items)),
    "GET": lambda items, words: ";".join(_at(items, word) for word in words),
    "JOIN": lambda items, words: "".join(words[:1]).join(items),
    "FIND": lambda items, words: str(items.index(words[0]) if words and words[0] in items else -1),
    "SUBLIST": lambda items, words: ";".join(_part(items, words)),
}
_LIST_CHANGES: dict[str, Callable[[list[str], list[str]], list[str]]] = {
    "APPEND": lambda items, words: [*items, *words],
    "PREPEND": lambda items, words: [*words, *items],
    "INSERT": lambda items, words: [*items[: _number(words[0])], *words[1:], *items[_number(words[0]) :]],
    "REMOVE_ITEM": lambda items, words: [item for item in items if item not in words],
    "REMOVE_AT": lambda items, words: [
        item
        for at, item in enumerate(items)
        if not {at, at - len(items)} & {_number(word, -len(items) - 1) for word in words}
    ],
    "REMOVE_DUPLICATES": lambda items, words: list(dict.fromkeys(items)),
    "SORT": lambda items, words: sorted(items),
    "REVERSE": lambda items, words: items[::-1],
    "FILTER": lambda items, words: [item for item in items if bool(_found(words[-1], item)) == (words[0] == "INCLUDE")],
}


# -- texts -------------------------------------------------------------------------------------------------------------


def _found(pattern: str, text: str) -> bool:
    try:
        return user_pattern(pattern).search(text) is not None
    except re.error:
        return False


def _string(words: list[str], variables: Variables, folder: Path) -> None:
    verb, *words = words or [""]
    if verb == "REGEX" and len(words) >= 4:
        _regex(words, variables)
    elif verb in ("APPEND", "PREPEND") and words:
        old, new = variables.get(words[0], ""), "".join(words[1:])
        variables[words[0]] = old + new if verb == "APPEND" else new + old
    elif verb in _STRINGS and len(words) > _STRINGS[verb][0]:
        target, change = _STRINGS[verb]
        variables[words[target]] = change([*words[:target], *words[target + 1 :]])


def _regex(words: list[str], variables: Variables) -> None:
    """Run `string(REGEX MATCH|MATCHALL PATTERN VARIABLE TEXT…)` or `string(REGEX REPLACE PATTERN NEW VARIABLE TEXT…)`."""
    verb, pattern, *words = words
    new = words.pop(0) if verb == "REPLACE" else ""
    target, text = words[0], "".join(words[1:])
    try:
        matches = list(islice(user_pattern(pattern).finditer(text), 1 if verb == "MATCH" else None))
    except re.error:
        return
    if verb != "REPLACE":
        variables[target] = ";".join(match.whole for match in matches)
    else:
        pieces, at = [], 0
        for match in matches:
            pieces += [text[at : match.spans[0]], _with_groups(new, match)]
            at = match.spans[1]
        variables[target] = "".join([*pieces, text[at:]])
    for name in [name for name in variables if name.startswith("CMAKE_MATCH_")]:
        del variables[name]
    for match in matches[-1:]:
        variables.update({f"CMAKE_MATCH_{number}": match[number] or "" for number in range(len(match.spans) // 2)})


def _with_groups(text: str, match: Match) -> str:
    """Return the text with `\\1` replaced by the first group of a match, and so on."""
    parts = re.split(r"\\([0-9])", text)
    known = len(match.spans) // 2
    parts[1::2] = [(match[int(number)] or "") if int(number) < known else "" for number in parts[1::2]]
    return "".join(parts)


def _compare(words: list[str]) -> str:
    a, b = words[1:3]
    order = {
        "LESS": a < b,
        "GREATER": a > b,
        "EQUAL": a == b,
        "NOTEQUAL": a != b,
        "LESS_EQUAL": a <= b,
        "GREATER_EQUAL": a >= b,
    }
    return str(int(order.get(words[0], False)))


_STRINGS: dict[str, tuple[int, Callable[[list[str]], str]]] = {
    "CONCAT": (0, "".join),
    "JOIN": (1, lambda words: words[0].join(words[1:])),
    "TOLOWER": (1, lambda words: words[0].lower()),
    "TOUPPER": (1, lambda words: words[0].upper()),
    "STRIP": (1, lambda words: words[0].strip()),
    "LENGTH": (1, lambda words: str(len(words[0].encode()))),
    "REPLACE": (2, lambda words: "".join(words[2:]).replace(words[0], words[1])),
    "SUBSTRING": (3, lambda words: "".join(_part(words[0], words[1:]))),
    "FIND": (2, lambda words: str(words[0].rfind(words[1]) if "REVERSE" in words else words[0].find(words[1]))),
    "REPEAT": (2, lambda words: words[0] * min(max(_number(words[1]), 0), _MOST_FILE // max(len(words[0]), 1))),
    "COMPARE": (3, _compare),
    "MAKE_C_IDENTIFIER": (1, lambda words: re.sub(r"^(?=\d)|\W", "_", words[0])),
}
"""verb of `string` -> which of its words names the variable for the result, and what works it out from the others"""

# -- numbers -----------------------------------------------------------------------------------------------------------

_PRECEDENCE: tuple[dict[str, Callable[[int, int], int]], ...] = (
    {"|": lambda a, b: a | b},
    {"^": lambda a, b: a ^ b},
    {"&": lambda a, b: a & b},
    {"<<": lambda a, b: a << min(max(b, 0), 63), ">>": lambda a, b: a >> max(b, 0)},
    {"+": lambda a, b: a + b, "-": lambda a, b: a - b},
    {"*": lambda a, b: a * b, "/": lambda a, b: int(a / b), "%": lambda a, b: a - b * int(a / b)},
)
_TOKEN = re.compile(r"\s*(0[xX][0-9a-fA-F]+|\d+|<<|>>|[-+*/%|&^~()])")


def _math(words: list[str], variables: Variables, folder: Path) -> None:
    if len(words) < 3 or words[0] != "EXPR":
        return
    tokens = _TOKEN.findall(words[2])
    try:
        value = _worked_out(tokens, 0)
    except (ValueError, IndexError, ArithmeticError):
        return
    variables[words[1]] = hex(value) if words[-1] == "HEXADECIMAL" else str(value)


def _worked_out(tokens: list[str], level: int) -> int:
    if level == len(_PRECEDENCE):
        return _operand(tokens)
    value = _worked_out(tokens, level + 1)
    while tokens and tokens[0] in _PRECEDENCE[level]:
        operator = tokens.pop(0)
        value = _PRECEDENCE[level][operator](value, _worked_out(tokens, level + 1))
    return value


def _operand(tokens: list[str]) -> int:
    token = tokens.pop(0)
    if token in ("-", "+", "~"):
        value = _operand(tokens)
        return {"-": -value, "+": value, "~": ~value}[token]
    if token != "(":
        return int(token, 16 if token[:2].lower() == "0x" else 10)
    value = _worked_out(tokens, 0)
    tokens.pop(0)
    return value


# -- files -------------------------------------------------------------------------------------------------------------


def _file(words: list[str], variables: Variables, folder: Path) -> None:
    if len(words) < 2:
        return
    verb, name, *more = words
    if verb in ("GLOB", "GLOB_RECURSE"):
        variables[name] = ";".join(_globbed(verb, more, folder))
    elif verb in ("READ", "STRINGS") and more:
        text = _content(folder / name)
        if verb == "STRINGS":
            lines = (line for line in text.splitlines() if line)
            if "REGEX" in more[:-1]:
                pattern = more[more.index("REGEX") + 1]
                lines = (line for line in lines if _found(pattern, line))
            text = ";".join(lines)
        variables[more[0]] = text


def _content(path: Path) -> str:
    try:
        if not path.is_file():  # reading a pipe waits for its writer
            return ""
        with path.open(encoding="utf-8", errors="replace") as file:
            return file.read(_MOST_FILE)
    except OSError:
        return ""


def _globbed(mode: str, words: list[str], folder: Path) -> Iterator[str]:
    """Yield the files that `file(GLOB …)` finds."""
    words = [word for word in words if word not in ("CONFIGURE_DEPENDS", "LIST_DIRECTORIES", "true", "false")]
    start = None
    if words[:1] == ["RELATIVE"] and len(words) > 1:
        start, words = folder / words[1], words[2:]
    for word in words:
        where, pattern = (folder / word).parent, Path(word).name
        for path in sorted(where.rglob(pattern) if mode == "GLOB_RECURSE" else where.glob(pattern)):
            yield (path.relative_to(start) if start is not None and start in path.parents else path).as_posix()


def _filename_component(words: list[str], variables: Variables, folder: Path) -> None:
    if len(words) < 3:
        return
    name, text, mode = words[:3]
    path = Path(text)
    parts = {
        "NAME": path.name,
        "NAME_WE": path.name.partition(".")[0],
        "NAME_WLE": path.stem,
        "EXT": "".join(path.name.partition(".")[1:]),
        "LAST_EXT": path.suffix,
        "DIRECTORY": "" if str(path.parent) == "." else path.parent.as_posix(),
        "PATH": "" if str(path.parent) == "." else path.parent.as_posix(),
        "ABSOLUTE": os.path.normpath(folder / path),
        "REALPATH": os.path.realpath(folder / path),
    }
    variables[name] = parts.get(mode, "")


def _parse_arguments(words: list[str], variables: Variables, folder: Path) -> None:
    """Run `cmake_parse_arguments(PREFIX OPTIONS ONE_VALUE MANY_VALUES ARG…)`, which packages' functions use."""
    if len(words) < 4:
        return
    prefix, *lists = words[:4]
    options, ones, many = (items_of(text) for text in lists)
    found: dict[str, list[str]] = {}
    current = "UNPARSED_ARGUMENTS"
    for word in (part for each in words[4:] for part in each.split(";")):
        if word in options or word in ones or word in many:
            current = "UNPARSED_ARGUMENTS" if word in options else word
            found[word] = ["TRUE"] if word in options else []
            continue
        found.setdefault(current, []).append(word)
        if current in ones:
            current = "UNPARSED_ARGUMENTS"
    for name in (*options, *ones, *many, "UNPARSED_ARGUMENTS"):
        variables.pop(f"{prefix}_{name}", None)
        if name in options or name in found:
            variables[f"{prefix}_{name}"] = ";".join(found.get(name, ["FALSE"]))


VALUE_COMMANDS: dict[str, ValueCommand] = {
    "option": _option,
    "unset": _unset,
    "list": _list,
    "string": _string,
    "math": _math,
    "file": _file,
    "get_filename_component": _filename_component,
    "cmake_parse_arguments": _parse_arguments,
}
