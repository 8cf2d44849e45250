"""How fast something is played that a person looks at: a quarter to four times, in steps."""

from __future__ import annotations

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0)

_WORDS = {0.25: "¼", 0.5: "½", 1.0: "1", 2.0: "2", 4.0: "4"}
_PLAIN = {0.25: "1/4", 0.5: "1/2"}


def changed(speed: float, step: int) -> float:
    """The next speed up or down; the same at the end of the list."""
    at = SPEEDS.index(speed) + step
    return SPEEDS[max(0, min(at, len(SPEEDS) - 1))]


def in_words(speed: float, *, unicode: bool = True) -> str:
    """A speed as it is shown: '¼×', '2×'; '1/4x' where there is only ASCII."""
    return f"{_WORDS[speed]}×" if unicode else f"{_PLAIN.get(speed, _WORDS[speed])}x"
