"""The value of `$((…))` and `((…))`: whole numbers of 64 bits with C's operators, as in bash."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, MutableMapping
from functools import partial

from day6_core.shell.language.variables import Variables
from day6_core.shell.language.words import end_of_subscript

_TOKEN = re.compile(
    r"\s*(?:(\d[\w#@]*)|([A-Za-z_]\w*\[?)"
    r"|(<<=|>>=|\*\*|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&^|]=|[-+*/%()<>!~&|^?:=,]))",
    re.ASCII,
)
_DIGITS = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ@_"
"""Of the highest base, 64; up to 36 the case of a letter does not matter."""
_MOST_DEPTH = 100

_BINARY: dict[str, tuple[int, Callable[[int, int], int]]] = {
    "||": (1, lambda a, b: int(bool(a) or bool(b))),
    "&&": (2, lambda a, b: int(bool(a) and bool(b))),
    "|": (3, operator.or_),
    "^": (4, operator.xor),
    "&": (5, operator.and_),
    "==": (6, lambda a, b: int(a == b)),
    "!=": (6, lambda a, b: int(a != b)),
    "<": (7, lambda a, b: int(a < b)),
    "<=": (7, lambda a, b: int(a <= b)),
    ">": (7, lambda a, b: int(a > b)),
    ">=": (7, lambda a, b: int(a >= b)),
    "<<": (8, lambda a, b: a << (b & 63)),
    ">>": (8, lambda a, b: a >> (b & 63)),
    "+": (9, operator.add),
    "-": (9, operator.sub),
    "*": (10, operator.mul),
    "/": (10, lambda a, b: _divide(a, b)),
    "%": (10, lambda a, b: a - b * _divide(a, b)),
    "**": (11, lambda a, b: pow(a, b, 2**64)),
}
_ASSIGNING = frozenset({"=", "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|="})
_UNARY: dict[str, Callable[[int], int]] = {
    "-": operator.neg,
    "+": operator.pos,
    "!": lambda a: int(not a),
    "~": operator.inv,
}


class ArithmeticProblem(ValueError):
    """An expression without a value, in bash's words: the expression, what is wrong, and from where on."""

    unbound = False
    """Whether a variable is not set that has to be."""

    def __init__(self, expression: str, problem: str, rest: str) -> None:
        super().__init__(f'{expression}: {problem} (error token is "{rest}")')


class UnsetProblem(ArithmeticProblem):
    """A variable that is not set, under `set -u`."""

    unbound = True

    def __init__(self, name: str) -> None:
        ValueError.__init__(self, f"{name}: unbound variable")


def evaluate(source: str, variables: MutableMapping[str, str], depth: int = 0, *, unset_is_wrong: bool = False) -> int:
    """Return the value; assignments change `variables`, whose values may be expressions themselves.

    Raises:
        ArithmeticProblem: `source` is not an expression, or divides by 0.
    """
    evaluator = _Evaluator(source, variables, depth, unset_is_wrong)
    if depth > _MOST_DEPTH:
        raise evaluator.problem("expression recursion level exceeded")
    value = evaluator.comma() if evaluator.tokens else 0
    if evaluator.tokens:
        raise evaluator.problem("syntax error in expression")
    return value


class _Evaluator:
    """Evaluates while it parses; while `quiet` is not 0 (in a branch that is not taken) nothing is assigned."""

    def __init__(self, source: str, variables: MutableMapping[str, str], depth: int, unset_is_wrong: bool) -> None:
        self.unset_is_wrong = unset_is_wrong
        self.source = source.lstrip()
        self.variables = variables
        self.depth = depth
        self.quiet = 0
        self.tokens: list[str] = []
        self.starts: list[int] = []
        """Where each of the tokens that are left begins."""
        self.last = 0
        """Where the last one that was read begins."""
        self._split()

    def _split(self) -> None:
        at, end = 0, len(self.source.rstrip())
        while at < end:
            match = _TOKEN.match(self.source, at)
            if match is None:
                rest = self.source[at:].lstrip()
                after_operand = bool(self.tokens) and self.tokens[-1][0] in f"{_DIGITS})"
                what = "invalid arithmetic operator" if after_operand else "operand expected"
                raise ArithmeticProblem(self.source, f"syntax error: {what}", rest)
            at = match.end()
            if self.source[at - 1] == "[":  # an element of an array is one token, with its subscript
                bracket = end_of_subscript(self.source, at - 1)
                if bracket < 0:
                    raise ArithmeticProblem(self.source, "bad array subscript", self.source[match.start() :])
                at = bracket + 1
            self.starts.append(match.start(match.lastindex or 0))
            self.tokens.append(self.source[self.starts[-1] : at])

    def take(self) -> str:
        self.last = self.starts.pop(0)
        return self.tokens.pop(0)

    def problem(self, text: str, at: int | None = None) -> ArithmeticProblem:
        """What is wrong at a place; by default at the next token, at the end at the last one."""
        if at is None:
            at = self.starts[0] if self.starts else self.last
        return ArithmeticProblem(self.source, text, self.source[at:])

    def next_is(self, *texts: str) -> bool:
        return bool(self.tokens) and self.tokens[0] in texts

    def comma(self) -> int:
        value = self.assignment()
        while self.next_is(","):
            self.take()
            value = self.assignment()
        return value

    def assignment(self) -> int:
        if len(self.tokens) > 1 and self.tokens[1] in _ASSIGNING and _is_name(self.tokens[0]):
            name, symbol, place = self.take(), self.take(), self.starts[:1]
            value = self.assignment()
            if symbol != "=":
                value = self.combine(symbol[:-1], self.value_of(name), value, *place)
            return self.assign(name, value)
        value = self.choice()
        if self.tokens and self.tokens[0] in _ASSIGNING:
            raise self.problem("attempted assignment to non-variable")
        return value

    def choice(self) -> int:
        condition = self.binary(0)
        if not self.next_is("?"):
            return condition
        self.take()
        if not self.tokens or self.next_is(":"):
            raise self.problem("expression expected")
        first = self.skipping(not condition, self.comma)
        if not self.next_is(":"):
            raise self.problem("`:' expected for conditional expression")
        self.take()
        if not self.tokens:
            raise self.problem("expression expected")
        second = self.skipping(bool(condition), self.choice)
        return first if condition else second

    def skipping(self, skipped: bool, read: Callable[[], int]) -> int:
        self.quiet += skipped
        try:
            return read()
        finally:
            self.quiet -= skipped

    def binary(self, lowest: int) -> int:
        value = self.operand()
        while self.tokens:
            precedence = _BINARY.get(self.tokens[0], (-1, operator.add))[0]
            if precedence < lowest:
                break
            name = self.take()
            place = self.starts[:1]
            decided = (name == "&&" and not value) or (name == "||" and bool(value))
            step = precedence if name == "**" else precedence + 1
            right = self.skipping(decided, partial(self.binary, step))
            value = self.combine(name, value, right, *place)
        return value

    def combine(self, name: str, left: int, right: int, place: int = 0) -> int:
        """The value of `left name right`; the right one begins at `place`."""
        if self.quiet:
            return 0
        if name in ("/", "%") and right == 0:
            raise self.problem("division by 0", place)
        if name == "**" and right < 0:
            raise self.problem("exponent less than 0")
        return _wrapped(_BINARY[name][1](left, right))

    def operand(self) -> int:
        if not self.tokens:
            raise self.problem("syntax error: operand expected")
        token = self.tokens[0]
        if token in ("++", "--") and not (len(self.tokens) > 1 and _is_name(self.tokens[1])):
            self.tokens[:1], self.starts[:1] = token, [self.starts[0], self.starts[0] + 1]  # two signs, as in --5
            token = token[0]
        if not (token[0] in _DIGITS or token in ("(", "++", "--", *_UNARY)):
            raise self.problem("syntax error: operand expected")
        self.take()
        if token[0].isdigit():
            return self.number(token)
        if token == "(":
            value = self.comma()
            if not self.next_is(")"):
                raise self.problem("missing `)'")
            self.take()
            return value
        if token in ("++", "--"):
            name = self.take()
            return self.assign(name, self.value_of(name) + (1 if token == "++" else -1))
        if token in _UNARY:
            return _wrapped(_UNARY[token](self.operand()))
        value = self.value_of(token)
        if self.next_is("++", "--"):
            self.assign(token, value + (1 if self.take() == "++" else -1))
        return value

    def number(self, text: str) -> int:
        mark = "#" in text
        if mark:
            before, _, digits = text.partition("#")
            base = int(before) if before.isdigit() else 0
            if not 2 <= base <= 64:
                raise self._number_problem("invalid arithmetic base", text)
            if not digits:
                raise self._number_problem("invalid integer constant", text)
        else:
            base, digits = (16, text[2:]) if text[:2] in ("0x", "0X") else (8, text) if text[0] == "0" else (10, text)
        value = 0
        for digit in digits.lower() if base <= 36 else digits:
            worth = _DIGITS.find(digit)
            if not 0 <= worth < base:
                raise self._number_problem("invalid number" if digit == "#" else "value too great for base", text)
            value = value * base + worth
        return _wrapped(value)

    def _number_problem(self, what: str, text: str) -> ArithmeticProblem:
        return ArithmeticProblem(self.source[: self.last + len(text)], what, text)

    def value_of(self, name: str) -> int:
        text = self._text_of(name)
        if text is None and self.unset_is_wrong and not self.quiet:
            raise UnsetProblem(name)
        text = (text or "").strip()
        if not text or self.quiet:
            return 0
        return evaluate(text, self.variables, self.depth + 1, unset_is_wrong=self.unset_is_wrong)

    def _text_of(self, name: str) -> str | None:
        base, bracket, subscript = name.partition("[")
        if not bracket:
            return self.variables.get(name)
        if not isinstance(self.variables, Variables) or self.quiet:
            return None
        return self.variables.element(base, self._key(base, subscript[:-1]))

    def _key(self, name: str, subscript: str) -> str:
        """The key of an element: of an associative array the text itself."""
        assert isinstance(self.variables, Variables)
        cell = self.variables.find(name)
        if cell is not None and cell.keyed:
            return subscript.replace('"', "").replace("'", "")
        return str(evaluate(subscript, self.variables, self.depth + 1, unset_is_wrong=self.unset_is_wrong))

    def assign(self, name: str, value: int) -> int:
        value = _wrapped(value)
        if self.quiet:
            return value
        base, bracket, subscript = name.partition("[")
        if bracket and isinstance(self.variables, Variables):
            self.variables.assign(base, str(value), key=self._key(base, subscript[:-1]))
        else:
            self.variables[name] = str(value)
        return value


def _is_name(token: str) -> bool:
    return token[0].isalpha() or token[0] == "_"


def _wrapped(value: int) -> int:
    """Wrap the value to a signed integer of 64 bits."""
    return (value + 2**63) % 2**64 - 2**63


def _divide(a: int, b: int) -> int:
    """Divide as C does: towards zero."""
    quotient = abs(a) // abs(b)
    return quotient if (a < 0) == (b < 0) else -quotient
