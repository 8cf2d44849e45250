"""The value of `$((…))` and `((…))`: whole numbers of 64 bits with C's operators, as in bash."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, MutableMapping
from functools import partial

_TOKEN = re.compile(
    r"\s*(?:(0[xX][0-9a-fA-F]+|\d+#\w+|\d+)|([A-Za-z_]\w*)"
    r"|(<<=|>>=|\*\*|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&^|]=|[-+*/%()<>!~&|^?:=,]))",
    re.ASCII,
)
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
    "**": (11, lambda a, b: _power(a, b)),
}
_ASSIGNING = frozenset({"=", "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|="})
_UNARY: dict[str, Callable[[int], int]] = {
    "-": operator.neg,
    "+": operator.pos,
    "!": lambda a: int(not a),
    "~": operator.inv,
}


def evaluate(source: str, variables: MutableMapping[str, str], depth: int = 0) -> int:
    """Return the value; assignments change `variables`, whose values may be expressions themselves.

    Raises ValueError (bash's text) if `source` is not an expression, ZeroDivisionError with bash's text.
    """
    if depth > _MOST_DEPTH:
        raise ValueError("expression recursion level exceeded")
    tokens: list[str] = []
    at = 0
    text = source.strip()
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(f'syntax error: invalid arithmetic operator (error token is "{text[at:].strip()}")')
        tokens.append(match.group().strip())
        at = match.end()
    parser = _Evaluator(tokens, variables, depth)
    value = parser.comma() if tokens else 0
    if parser.tokens:
        raise ValueError(f'syntax error in expression (error token is "{" ".join(parser.tokens)}")')
    return value


class _Evaluator:
    """Evaluates while it parses; while `quiet` is not 0 (in a branch that is not taken) nothing is assigned."""

    def __init__(self, tokens: list[str], variables: MutableMapping[str, str], depth: int) -> None:
        self.tokens = tokens
        self.variables = variables
        self.depth = depth
        self.quiet = 0
        self.last = ""
        """The last operator that was read, for messages."""

    def next_is(self, *texts: str) -> bool:
        return bool(self.tokens) and self.tokens[0] in texts

    def comma(self) -> int:
        value = self.assignment()
        while self.next_is(","):
            self.tokens.pop(0)
            value = self.assignment()
        return value

    def assignment(self) -> int:
        if len(self.tokens) > 1 and self.tokens[1] in _ASSIGNING and self.tokens[0].isidentifier():
            name, symbol = self.tokens.pop(0), self.tokens.pop(0)
            value = self.assignment()
            if symbol != "=":
                value = self.combine(symbol[:-1], self.value_of(name), value)
            return self.assign(name, value)
        return self.choice()

    def choice(self) -> int:
        condition = self.binary(0)
        if not self.next_is("?"):
            return condition
        self.tokens.pop(0)
        first = self.skipping(not condition, self.comma)
        if not self.next_is(":"):
            raise ValueError("`:' expected for conditional expression")
        self.tokens.pop(0)
        second = self.skipping(bool(condition), self.assignment)
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
            name = self.last = self.tokens.pop(0)
            decided = (name == "&&" and not value) or (name == "||" and bool(value))
            step = precedence if name == "**" else precedence + 1
            right = self.skipping(decided, partial(self.binary, step))
            value = self.combine(name, value, right)
        return value

    def combine(self, name: str, left: int, right: int) -> int:
        if self.quiet:
            return 0
        return _wrapped(_BINARY[name][1](left, right))

    def operand(self) -> int:
        if not self.tokens:
            raise ValueError(f'syntax error: operand expected (error token is "{self.last}")')
        token = self.tokens.pop(0)
        if token[0].isdigit():
            return _number(token)
        if token == "(":
            value = self.comma()
            if not self.next_is(")"):
                raise ValueError("missing `)'")
            self.tokens.pop(0)
            return value
        if token in ("++", "--") and self.tokens and self.tokens[0].isidentifier():
            name = self.tokens.pop(0)
            return self.assign(name, self.value_of(name) + (1 if token == "++" else -1))
        if token in _UNARY:
            return _wrapped(_UNARY[token](self.operand()))
        if token.isidentifier():
            value = self.value_of(token)
            if self.next_is("++", "--"):
                self.assign(token, value + (1 if self.tokens.pop(0) == "++" else -1))
            return value
        raise ValueError(f'syntax error: operand expected (error token is "{" ".join([token, *self.tokens])}")')

    def value_of(self, name: str) -> int:
        text = self.variables.get(name, "").strip()
        if not text:
            return 0
        return evaluate(text, self.variables, self.depth + 1)

    def assign(self, name: str, value: int) -> int:
        value = _wrapped(value)
        if not self.quiet:
            self.variables[name] = str(value)
        return value


def _number(text: str) -> int:
    base, mark, digits = text.partition("#")
    try:
        if mark:
            return int(digits, int(base))
        if text[:2] in ("0x", "0X"):
            return int(text, 16)
        return int(text, 8) if text.startswith("0") else int(text)
    except ValueError:
        raise ValueError(f'{text}: value too great for base (error token is "{text}")') from None


def _wrapped(value: int) -> int:
    """Wrap the value to a signed integer of 64 bits."""
    return (value + 2**63) % 2**64 - 2**63


def _power(a: int, b: int) -> int:
    if b < 0:
        raise ValueError("exponent less than 0")
    return pow(a, b, 2**64)


def _divide(a: int, b: int) -> int:
    """Divide as C does: towards zero."""
    if b == 0:
        raise ZeroDivisionError("division by 0")
    quotient = abs(a) // abs(b)
    return quotient if (a < 0) == (b < 0) else -quotient
