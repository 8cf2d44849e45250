"""Regular expressions as pupils read them: as a text that they match."""

from __future__ import annotations

import re

ANYTHING = "…"

_TOKEN = re.compile(
    r"\\."  # an escaped character, or a class of them
    r"|\[\^?\]?(?:\\.|[^\]\\])*\]"  # a set
    r"|\(\?(?:[aiLmsux]+\)|P<\w+>|<?[=!]|:)?|\("  # flags, and what opens a group
    r"|[*+?]\??|\{\d*,?\d*\}\??"  # how often
    r"|.",
    re.DOTALL,
)
_QUANTIFIER = re.compile(r"[*+?]\??|\{\d*,?\d*\}\??")


def readable(pattern: str) -> str:
    """Return what a regular expression stands for: of alternatives the first, `…` for anything; nothing of its signs."""
    text = _example(_TOKEN.findall(pattern)[::-1])
    return re.sub(f"{ANYTHING}+", ANYTHING, text).strip(f"{ANYTHING} ") or pattern


def _example(tokens: list[str]) -> str:
    """A text for the tokens (the next one is the last) up to the end of their group."""
    written: list[str] = []
    first: str | None = None
    while tokens and (token := tokens.pop()) != ")":
        if token == "|":
            first, written = "".join(written) if first is None else first, []
        else:
            piece = _piece(token, tokens)
            often = tokens.pop() if tokens and _QUANTIFIER.fullmatch(tokens[-1]) else ""
            if token == "." and often:
                piece = ANYTHING
            elif (often.startswith(("*", "{0", "{,")) and piece != ANYTHING) or (
                often[:1] == "?" and ANYTHING in piece
            ):
                piece = ""
            written.append(piece)
    return "".join(written) if first is None else first


def _piece(token: str, tokens: list[str]) -> str:
    if token.startswith("("):
        inside = "" if token.endswith(")") else _example(tokens)
        return "" if token.endswith(("=", "!")) else inside
    if token in ("^", "$", "\\b", "\\B", "\\A", "\\Z"):
        return ""
    if token.startswith("["):
        return ANYTHING if token[1] in "^\\" else token[1]
    if token == r"\s":
        return " "
    return ANYTHING if re.fullmatch(r"\\[SwWdD]", token) else token[-1]
