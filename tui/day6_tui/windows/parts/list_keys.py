"""The keys of lists and of sliders in them, the same in every window that draws its own."""

from __future__ import annotations

SLIDER_STEPS = {"right": 1, "left": -1, "shift+right": 10, "shift+left": -10}
"""Keys that move the chosen slider, by how many of its steps."""

SLIDER_FINEST = {"ctrl+right": 1, "ctrl+left": -1}
"""Keys that move it by as little as it can."""

BEGINS_NUMBER = frozenset("0123456789.-")
"""What is typed on a line begins its number anew."""

END = 10**9


def list_steps(key: str, page: int, *, ends: bool = True) -> int | None:
    """By how many lines a key moves the cursor of a list of which `page` lines are seen; None for any other key.

    `ends`: whether Home and End are the list's, and not those of a slider on the line.
    """
    far = max(1, page - 1)
    steps = {"up": -1, "down": 1, "pageup": -far, "pagedown": far}
    return {**steps, "home": -END, "end": END}.get(key) if ends else steps.get(key)


def first_seen(first: int, at: int, height: int, count: int) -> int:
    """The first line of a list of `count` that is seen, so that `at` is in sight and as little as possible moves."""
    first = min(max(first, at - height + 1), at)
    return max(0, min(first, count - height))
