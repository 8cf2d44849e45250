"""The value of `$((…))`: whole numbers with C's operators, as in bash."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping

_TOKEN = re.compile(r"\s*(?:(\d+)|([A-Za-z_]\w*)|(\*\*|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%()<>!~&|^?:]))")

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
    "<<": (8, lambda a, b: a << min(b, 63)),
    ">>": (8, lambda a, b: a >> min(b, 63)),
    "+": (9, operator.add),
    "-": (9, operator.sub),
    "*": (10, operator.mul),
    "/": (10, lambda a, b: _divide(a, b)),
    "%": (10, lambda a, b: a - b * _divide(a, b)),
    "**": (11, lambda a, b: a ** min(b, 64)),
}
_UNARY: dict[str, Callable[[int], int]] = {
    "-": operator.neg,
    "+": operator.pos,
    "!": lambda a: int(not a),
    "~": operator.inv,
}


def evaluate(source: str, variables: Mapping[str, str]) -> int:
    """Return the value. Raises ValueError (bash's text) for what is no sum, ZeroDivisionError with bash's text."""
    tokens: list[str] = []
    at = 0
    text = source.strip().replace("$", "")
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(f'syntax error: invalid arithmetic operator (error token is "{text[at:]}")')
        tokens.append(match.group().strip())
        at = match.end()
    parser = _Parser(tokens, variables)
    value = parser.expression(0) if tokens else 0
    if parser.tokens:
        raise ValueError(f'syntax error in expression (error token is "{" ".join(parser.tokens)}")')
    return (value + 2**63) % 2**64 - 2**63


class _Parser:
    def __init__(self, tokens: list[str], variables: Mapping[str, str]) -> None:
        self.tokens = tokens
        self.variables = variables

    def expression(self, lowest: int) -> int:
        value = self.operand()
        while self.tokens:
            precedence, function = _BINARY.get(self.tokens[0], (-1, operator.add))
            if precedence < lowest:
                break
            name = self.tokens.pop(0)
            value = function(value, self.expression(precedence if name == "**" else precedence + 1))
        return value

    def operand(self) -> int:
        if not self.tokens:
            raise ValueError("syntax error: operand expected")
        token = self.tokens.pop(0)
        if token.isdigit():
            return int(token)
        if token == "(":
            value = self.expression(0)
            if not self.tokens or self.tokens.pop(0) != ")":
                raise ValueError("missing `)'")
            return value
        if token in _UNARY:
            return _UNARY[token](self.operand())
        if token.isidentifier():
            text = self.variables.get(token, "").strip()
            return int(text) if text.lstrip("-").isdigit() else 0
        raise ValueError(f'syntax error: operand expected (error token is "{token}")')


def _divide(a: int, b: int) -> int:
    """C's division: towards zero."""
    if b == 0:
        raise ZeroDivisionError("division by 0")
    quotient = abs(a) // abs(b)
    return quotient if (a < 0) == (b < 0) else -quotient
