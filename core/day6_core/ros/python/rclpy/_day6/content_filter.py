"""Content filters: the SQL subset of DDS by which a subscription selects messages (DDS 1.4, annex B).

`int32_value > %0 AND (name LIKE 'a%' OR NOT pose.x BETWEEN 1 AND 2)` becomes one function of a message.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

Test = Callable[[Any], bool]
Value = Callable[[Any], Any]

_TOKEN = re.compile(
    r"\s*(?:(?P<number>[+-]?(?:\d+\.\d*|\.\d+|\d+)(?:[eE][+-]?\d+)?(?![\w.]))|(?P<text>'(?:[^']|'')*'|`[^']*')"
    r"|(?P<parameter>%\d+)|(?P<name>[A-Za-z_]\w*(?:\[\d+\])?(?:\.[A-Za-z_]\w*(?:\[\d+\])?)*)"
    r"|(?P<sign><=|>=|<>|!=|=|<|>|\(|\)))"
)
_COMPARE: dict[str, Callable[[Any, Any], Any]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
_WORDS = frozenset(("AND", "OR", "NOT", "BETWEEN", "LIKE", "MATCH", "TRUE", "FALSE"))


class FilterError(ValueError):
    """The expression cannot be parsed, or does not fit the message type."""


class _Token(NamedTuple):
    kind: str
    text: str


class _Operand(NamedTuple):
    value: Value
    sample: Any
    """A default value of its type, which shows with which operands it can be compared."""
    is_field: bool


def compile_filter(expression: str, parameters: Sequence[str], msg_type: type[Any]) -> Test:
    """Compile an expression into a predicate on messages. FilterError if there is anything wrong with it."""
    parser = _Parser(_tokens(expression), parameters, msg_type())
    test = parser.condition()
    if parser.rest:
        raise FilterError(f"unexpected '{parser.rest[0].text}' in '{expression}'")
    return test


def _tokens(expression: str) -> list[_Token]:
    found: list[_Token] = []
    at = 0
    while expression[at:].strip():
        match = _TOKEN.match(expression, at)
        if match is None:
            raise FilterError(f"cannot read '{expression[at:].strip()}'")
        kind = match.lastgroup or ""
        text = match[kind]
        if kind == "name" and text.upper() in _WORDS:
            kind, text = "word", text.upper()
        found.append(_Token(kind, text))
        at = match.end()
    return found


class _Parser:
    """Recursive descent: AND and OR, NOT, parentheses, comparisons."""

    def __init__(self, tokens: list[_Token], parameters: Sequence[str], example: Any) -> None:
        self.rest = tokens
        self._parameters = parameters
        self._example = example

    def _take(self, *texts: str) -> bool:
        if self.rest and self.rest[0].kind in ("word", "sign") and self.rest[0].text in texts:
            self._taken = self.rest.pop(0).text
            return True
        return False

    def _need(self, *texts: str) -> str:
        if not self._take(*texts):
            raise FilterError(f"expected {' or '.join(texts)} before '{self.rest[0].text if self.rest else 'the end'}'")
        return self._taken

    def condition(self) -> Test:
        """Read conditions joined by AND and OR: from left to right, neither binds more tightly, as with Fast DDS."""
        test = self._single()
        while self._take("AND", "OR"):
            test = _joined(self._taken, test, self._single())
        return test

    def _single(self) -> Test:
        if self._take("NOT"):
            test = self._single()
            return lambda message: not test(message)
        if self._take("("):
            inner = self.condition()
            self._need(")")
            return inner
        return self._comparison()

    def _comparison(self) -> Test:
        left = self._operand()
        negated = self._take("NOT")
        if self._take("BETWEEN"):
            low = self._operand()
            self._need("AND")
            high = self._operand()
            for each in (low, high):
                _check_kinds(left, each)
            return lambda message: (low.value(message) <= left.value(message) <= high.value(message)) != negated
        if negated:
            raise FilterError("expected BETWEEN after NOT")
        sign = self._need(*_COMPARE, "LIKE", "MATCH")
        right = self._operand()
        _check_kinds(left, right)
        if sign in ("LIKE", "MATCH"):
            return _matching(sign, left, right)
        compare, one, other = _COMPARE[sign], left.value, right.value
        return lambda message: bool(compare(one(message), other(message)))

    def _operand(self) -> _Operand:
        if not self.rest:
            raise FilterError("something is missing at the end")
        token = self.rest.pop(0)
        if token.kind == "parameter":
            number = int(token.text[1:])
            if number >= len(self._parameters):
                raise FilterError(f"there is no parameter {token.text}")
            return _literal(self._parameters[number])
        if token.kind == "name":
            return self._field(token.text)
        if token.kind == "sign" or (token.kind == "word" and token.text not in ("TRUE", "FALSE")):
            raise FilterError(f"unexpected '{token.text}'")
        return _literal(token.text)

    def _field(self, path: str) -> _Operand:
        steps: list[str | int] = []
        for part in path.split("."):
            name, _, index = part.partition("[")
            steps.append(name)
            if index:
                steps.append(int(index[:-1]))

        def value(message: Any) -> Any:
            found = message
            for step in steps:
                found = getattr(found, step) if isinstance(step, str) else found[step]
            return found

        try:
            sample = value(self._example)
        except AttributeError:
            raise FilterError(f"field '{path}' not found") from None
        except IndexError:
            sample = None
        return _Operand(value, sample, True)


def _joined(word: str, one: Test, other: Test) -> Test:
    if word == "AND":
        return lambda message: one(message) and other(message)
    return lambda message: one(message) or other(message)


def _literal(text: str) -> _Operand:
    value: Any
    if text[:1] in "'`" and text[-1:] == "'" and len(text) > 1:
        value = text[1:-1].replace("''", "'")
    elif text.upper() in ("TRUE", "FALSE"):
        value = text.upper() == "TRUE"
    else:
        try:
            value = int(text)
        except ValueError:
            try:
                value = float(text)
            except ValueError:
                raise FilterError(f"'{text}' is not a number, a text or a truth value") from None
    return _Operand(lambda _message: value, value, False)


def _check_kinds(left: _Operand, right: _Operand) -> None:
    if not (left.is_field or right.is_field):
        raise FilterError("a comparison needs a field of the message")
    samples = left.sample, right.sample
    if None in samples:
        # An element of a sequence that is empty at the moment.
        return
    texts = [isinstance(sample, str) for sample in samples]
    plain = [isinstance(sample, str) or hasattr(sample, "__float__") for sample in samples]
    if not all(plain) or texts[0] != texts[1]:
        raise FilterError("the two sides of a comparison have different types")


def _matching(sign: str, left: _Operand, right: _Operand) -> Test:
    if not isinstance(right.sample, str) or right.is_field:
        raise FilterError(f"{sign} needs a text")
    from day6_core.user_pattern import user_pattern

    pattern = right.sample
    if sign == "LIKE":
        wild = {"%": ".*", "*": ".*", "_": ".", "?": "."}
        # The rest is a regular expression to Fast DDS, so `.` is any character here too.
        pattern = "".join(wild.get(letter, letter) for letter in pattern)
    try:
        compiled = user_pattern(pattern, re.DOTALL)
    except re.error as error:
        raise FilterError(f"bad pattern: {error}") from None
    value = left.value
    return lambda message: compiled.fullmatch(value(message)) is not None
