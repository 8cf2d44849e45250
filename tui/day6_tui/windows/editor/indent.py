"""How deep a line of code begins: what Enter puts there, and when a text brings its own depth along."""

from __future__ import annotations

STEP = "    "
"""What Tab puts before a line."""

_OPENS = (":", "(", "[", "{")


def after(before: str, *, python: bool) -> str:
    """Return the blanks of the line after one: the same, in Python a step more after a colon or an open bracket."""
    deeper = python and before.rstrip().endswith(_OPENS)
    return before[: _depth(before)] + (STEP if deeper else "")


def shifted(line: str, steps: int) -> str:
    """Return a line moved right or left (`steps` below 0) by one step."""
    if steps > 0:
        return STEP + line if line.strip() else line
    blank = len(line) - len(line.lstrip(" "))
    return line[1:] if line.startswith("\t") else line[min(blank, len(STEP)) :]


def has_own_depth(text: str, depth: int) -> bool:
    """Whether a pasted text brings its own blanks, so that it must not begin `depth` columns from the left.

    Its first line may lack them because it was copied from its first letter on; then the next line says where it belongs.
    """
    first, _, rest = text.partition("\n")
    following = next((line for line in rest.split("\n") if line.strip()), None)
    if _depth(first) or following is None:
        return bool(_depth(first))
    if first.rstrip().endswith(_OPENS):
        return _depth(following) <= depth
    return _depth(following) != depth


def _depth(line: str) -> int:
    return len(line) - len(line.lstrip(" \t"))
