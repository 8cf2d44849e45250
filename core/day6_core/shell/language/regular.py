"""Regular expressions of `[[ … =~ … ]]`: POSIX's extended ones, as glibc reads them, in the words of Python's `re`."""

from __future__ import annotations

import re

from day6_core.shell.language.patterns import CLASSES

_GNU = {"<": r"\b(?=\w)", ">": r"\b(?<=\w)", "b": r"\b", "B": r"\B", "w": r"\w", "W": r"\W", "s": r"\s", "S": r"\S",
        "`": r"\A", "'": r"\Z"}  # fmt: skip
_REPEAT = re.compile(r"\{(\d*)(,?)(\d*)\}")


def regular(source: str) -> str:
    """Return the expression for `re`. Raises re.error."""
    found: list[str] = []
    at, depth = 0, 0
    while at < len(source):
        char = source[at]
        if char == "\\" and at + 1 < len(source):
            following = source[at + 1]
            found.append(
                _GNU.get(following) or (f"\\{following}" if following in "123456789" else re.escape(following))
            )
            at += 2
        elif char == "[":
            text, at = _bracket(source, at)
            found.append(text)
        elif char in "*+?":
            if not found or found[-1] in ("(", "|"):
                if char != "*":
                    raise re.error("Invalid preceding regular expression")
                found.append(r"\*")
            elif found[-1] in _REPEATS:  # a repeat of a repeat, which `re` reads in another way
                found[:] = _wrapped(found)
                found.append(char)
            else:
                found.append(char)
            at += 1
        elif char == "{":
            match = _REPEAT.match(source, at)
            if match is None or not (match[1] or match[3]) or not found:
                found.append(r"\{")
                at += 1
            else:
                found.append(f"{{{match[1] or '0'}{match[2]}{match[3]}}}")
                at = match.end()
        elif char == "(":
            depth += 1
            found.append("(")
            at += 1
        elif char == ")":
            found.append(")" if depth else r"\)")
            depth = max(depth - 1, 0)
            at += 1
        elif char == "$":
            found.append(r"\Z")
            at += 1
        elif char in "^.|":
            found.append(r"\A" if char == "^" else "(?s:.)" if char == "." else char)
            at += 1
        else:
            found.append(re.escape(char))
            at += 1
    if depth:
        raise re.error("Unmatched ( or \\(")
    return "".join(found)


_REPEATS = frozenset("*+?")


def _wrapped(found: list[str]) -> list[str]:
    """Put the last repeated part into a group of its own."""
    at = len(found) - 1
    while at and found[at] in _REPEATS:
        at -= 1
    start = at
    if found[at] == ")":
        depth = 0
        while start >= 0:
            depth += (found[start] == ")") - (found[start] == "(")
            if not depth:
                break
            start -= 1
    return [*found[:start], "(?:" + "".join(found[start:]) + ")"]


def _bracket(source: str, start: int) -> tuple[str, int]:
    """`[…]`, in which a backslash is an ordinary character; returns it and where it ends."""
    at = start + 1
    negated = source.startswith("^", at)
    at += negated
    found: list[str] = []
    first = True
    while at < len(source):
        if source[at] == "]" and not first:
            return f"[{'^' if negated else ''}{''.join(found)}]", at + 1
        first = False
        named = re.compile(r"\[:(\w+):\]").match(source, at)
        if named is not None:
            if named[1] not in CLASSES:
                raise re.error("Invalid character class name")
            found.append(CLASSES[named[1]])
            at = named.end()
            continue
        char = source[at]
        if source[at + 1 : at + 2] == "-" and source[at + 2 : at + 3] not in ("", "]"):
            last = source[at + 2]
            if last < char:
                raise re.error("Invalid range end")
            found.append(f"{_member(char)}-{_member(last)}")
            at += 3
        else:
            found.append(_member(char))
            at += 1
    raise re.error("Unmatched [, [^, [:, [., or [=")


def _member(char: str) -> str:
    return "\\" + char if char in r"\]^-[&|~" else char
