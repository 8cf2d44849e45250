"""Evaluates the condition of a CMake `if` or `while` (cmake manual, command `if`)."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from pathlib import Path

from day6_core.user_pattern import user_pattern

_TRUE = frozenset({"1", "ON", "YES", "TRUE", "Y"})
_FALSE = frozenset({"", "0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND"})
_UNARY = frozenset({"EXISTS", "DEFINED", "COMMAND", "TARGET", "POLICY", "IS_DIRECTORY", "IS_ABSOLUTE", "TEST"})


def evaluate(words: list[str], variables: Mapping[str, str], folder: Path) -> bool:
    """Evaluate the words between the parentheses; a quoted word begins with a quotation mark.

    Raises:
        ValueError: the words are not a condition.
    """
    condition = _Condition(list(words), variables, folder)
    value = condition.any_of()
    if condition.words:
        raise ValueError(condition.words[0])
    return value


def is_true(value: str) -> bool | None:
    """Return the truth of a constant, None for anything that isn't a constant."""
    upper = value.upper()
    if upper in _FALSE or upper.endswith("-NOTFOUND"):
        return False
    if upper in _TRUE:
        return True
    try:
        return float(value) != 0
    except ValueError:
        return None


def _version(text: str) -> tuple[int, ...]:
    numbers = [int(part) for part in re.findall(r"\d+", text)[:4]]
    return (*numbers, *[0] * (4 - len(numbers)))


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")


def _matches(text: str, pattern: str) -> bool:
    try:
        return user_pattern(pattern).search(text) is not None
    except re.error:
        return False


_BINARY: dict[str, Callable[[str, str], bool]] = {
    "STREQUAL": lambda a, b: a == b,
    "STRLESS": lambda a, b: a < b,
    "STRGREATER": lambda a, b: a > b,
    "EQUAL": lambda a, b: _number(a) == _number(b),
    "LESS": lambda a, b: _number(a) < _number(b),
    "GREATER": lambda a, b: _number(a) > _number(b),
    "LESS_EQUAL": lambda a, b: _number(a) <= _number(b),
    "GREATER_EQUAL": lambda a, b: _number(a) >= _number(b),
    "VERSION_EQUAL": lambda a, b: _version(a) == _version(b),
    "VERSION_LESS": lambda a, b: _version(a) < _version(b),
    "VERSION_GREATER": lambda a, b: _version(a) > _version(b),
    "VERSION_LESS_EQUAL": lambda a, b: _version(a) <= _version(b),
    "VERSION_GREATER_EQUAL": lambda a, b: _version(a) >= _version(b),
    "MATCHES": _matches,
}


class _Condition:
    """The unread words of a condition, with the variables and folder they refer to."""

    def __init__(self, words: list[str], variables: Mapping[str, str], folder: Path) -> None:
        self.words = words
        self._variables = variables
        self._folder = folder

    def any_of(self) -> bool:
        value = self._all_of()
        while self.words[:1] == ["OR"]:
            self.words.pop(0)
            value = self._all_of() or value
        return value

    def _all_of(self) -> bool:
        value = self._one()
        while self.words[:1] == ["AND"]:
            self.words.pop(0)
            value = self._one() and value
        return value

    def _one(self) -> bool:
        if not self.words:
            return False  # the word was a variable that is not set
        word = self.words.pop(0)
        if word == "NOT":
            return not self._one()
        if word == "(":
            value = self.any_of()
            if not self.words or self.words.pop(0) != ")":
                raise ValueError("(")
            return value
        if word in _UNARY and self.words and self.words[0] not in (")", "AND", "OR", *_BINARY):
            return self._test(word, self.words.pop(0).removeprefix('"'))
        if len(self.words) > 1 and self.words[0] in (*_BINARY, "IN_LIST"):
            operator, right = self.words.pop(0), self.words.pop(0)
            if operator == "IN_LIST":
                return self._value(word) in self._variables.get(right.removeprefix('"'), "").split(";")
            pattern = right.removeprefix('"') if operator == "MATCHES" else self._value(right)
            return _BINARY[operator](self._value(word), pattern)
        return self._is_word_true(word)

    def _test(self, operator: str, word: str) -> bool:
        if operator == "DEFINED":
            return word in self._variables
        if operator == "IS_ABSOLUTE":
            return os.path.isabs(word)
        if operator in ("EXISTS", "IS_DIRECTORY"):
            path = self._folder / word
            return bool(word) and (path.exists() if operator == "EXISTS" else path.is_dir())
        return False  # targets, policies and commands: nothing is compiled here

    def _value(self, word: str) -> str:
        """Return one side of a comparison: a variable's value, or the word itself."""
        return word[1:] if word.startswith('"') else self._variables.get(word, word)

    def _is_word_true(self, word: str) -> bool:
        constant = is_true(word.removeprefix('"'))
        if constant is not None or word.startswith('"'):
            return bool(constant)
        value = self._variables.get(word)
        return value is not None and is_true(value) is not False
