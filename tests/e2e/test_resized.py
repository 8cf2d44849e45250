"""A terminal window that is dragged narrower and wider: the text in the desktop's terminal is wrapped anew and comes back."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

PROMPT = "student@day6:~$"
PRINTED = "0123456789" * 15
TYPED = "echo " + "typed" * 20


def inside(screen: Terminal) -> list[str]:
    """The lines in the frame of the only pane, without what its title and the bars say."""
    return [line for line in screen.look().split("\n") if line.startswith("┃")]


def test_what_was_printed_and_what_is_being_typed_is_wrapped_anew_and_comes_back(place: Place) -> None:
    with place.desktop("--scene", "empty", columns=100, rows=30) as screen:
        screen.wait(PROMPT)
        screen.press("F8")  # the terminal alone
        screen.wait_gone("No window is open")
        screen.line("clear; python3 -c \"print('0123456789' * 15)\"")
        screen.wait(lambda _: PRINTED in "".join(screen.pieces()), PROMPT)
        screen.send(TYPED)

        def is_whole(_: str) -> bool:
            text = "".join(screen.pieces())
            return text.count(PRINTED) == 1 and text.count(TYPED) == 1 and text.count(PROMPT) == 1

        screen.wait(is_whole)
        before = inside(screen)
        for columns, rows in ((60, 30), (44, 24), (140, 20), (80, 24)):
            screen.resize(columns, rows)
            screen.wait(is_whole, PRINTED[: columns - 2])
        screen.resize(100, 30)
        screen.wait(lambda _: inside(screen) == before)
        screen.press("Ctrl-U")
        screen.line("echo do''ne")
        screen.wait_lines("done")
        assert PRINTED in "".join(screen.pieces())
