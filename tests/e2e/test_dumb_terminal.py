"""TERM=dumb: a terminal that knows no colours gets none, from the desktop and from the ordinary commands."""

from __future__ import annotations

import re

import pytest

from tests.e2e.place import Place

pytestmark = pytest.mark.person

COLOURS = re.compile(rb"\x1b\[[0-9;]*(?:3[0-8]|4[0-8]|9[0-7]|10[0-7])(?:;[0-9;]*)?m")
LINES = [
    "ros2 run demo_nodes_py talker & sleep 2; kill %1",
    "mkdir -p folder; ls; echo text | grep text",
    "ros2 nosuch",
]


@pytest.mark.parametrize("term", ["dumb", "xterm"])
def test_commands_write_colours_only_where_there_are_any(place: Place, term: str) -> None:
    seen = bytearray()
    for line in LINES:
        with place.terminal("exec", "--home", str(place.home), "-c", line, TERM=term) as screen:
            screen.wait_end()
            seen += screen.output
    assert b"text" in seen and b"folder" in seen
    assert bool(COLOURS.search(seen)) == (term == "xterm"), bytes(seen)


def test_the_desktop_draws_without_colours(place: Place) -> None:
    with place.desktop("--scene", "turtle", TERM="dumb", COLORTERM=None) as screen:
        screen.wait("TurtleSim", "'q' to quit")
        screen.press("F7")
        screen.wait("Commands")
        assert not COLOURS.search(screen.output)
        assert b"\x1b[5n" not in screen.output
