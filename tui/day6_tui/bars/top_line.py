"""The text of the upper bar: the desk's name, what runs on it, the speed of time."""

from __future__ import annotations

import math
from collections.abc import Callable

from day6_tui.actions import Actions
from day6_tui.bars.connections import door_words
from day6_tui.panes.cells import cell_len
from day6_tui.panes.pane import Piece
from day6_tui.parts import Feature, Parts

BAR_NAMES = {"turtlesim": "turtle", "world": "world", "car": "car"}
"""Kind of window -> the desk's name in the top bar while such a window is open."""


class TopLine(Feature):
    """Reads the machine at every frame; with `doors`, the state of the connections to other machines too."""

    def __init__(
        self,
        parts: Parts,
        actions: Actions,
        *,
        doors: bool,
        recording: Callable[[], str],
        lesson: Callable[[], list[Piece]],
        classroom: Callable[[bool], list[Piece]],
        offers: Callable[[bool], list[Piece]],
    ) -> None:
        super().__init__(parts)
        self._actions = actions
        self._doors = doors
        self._recording = recording
        self._lesson = lesson
        self._classroom = classroom
        """What the pupil of a class has to see; in short words, if asked for."""
        self._offers = offers
        """What is of use to the pupil, where there is room."""

    def pieces(self, width: int) -> tuple[list[Piece], list[Piece]]:
        """From the left and from the right; in short words where not all that matters has room."""
        switches = self._switches()
        for short in (False, True):
            left = [
                *self._name(),
                *self._lesson(),
                *self._recorded(),
                *self._classroom(short),
                *self._door_pieces(short),
            ]
            left += self._offers(short)
            if sum(cell_len(piece.text) for piece in (*left, *switches)) <= width:
                break
        return [*left, *self._running()], switches

    def _recorded(self) -> list[Piece]:
        """That the screen is being recorded; a click ends it."""
        if not (words := self._recording()):
            return []
        return [
            Piece(f" {self._look.glyphs.news} {words} ", self._look.colours.error, self._actions["record"]),
            Piece("  ", self._look.colours.bar),
        ]

    def _name(self) -> list[Piece]:
        colours = self._look.colours
        kinds = {pane.window.kind for pane in self._desktop.panes.values()}
        name = next((f"bar.{name}" for kind, name in BAR_NAMES.items() if kind in kinds), "bar.desk")
        return [
            Piece(" day6 ", colours.bar_strong),
            Piece(f"{self._look.glyphs.chevron} ", colours.bar_muted),
            Piece(f"{self._look.texts(name)}   ", colours.bar_strong),
        ]

    def _door_pieces(self, short: bool) -> list[Piece]:
        """The state of the connections to other machines; a click opens the inspector, which gives details."""
        colours = self._look.colours
        pieces = []
        for door in self._machine.doors() if self._doors else ():
            key, fine, words = door_words(door, self._look.glyphs.ellipsis, short=short)
            style = colours.bar if fine else colours.warning
            pieces.append(Piece(f"{self._look.texts(key, **words)}   ", style, self._actions["inspector"]))
        return pieces

    def _running(self) -> list[Piece]:
        colours, texts = self._look.colours, self._look.texts
        if self._machine.desk is None:
            return [Piece(texts("bar.starting"), colours.bar_muted)]
        nodes, topics = self._machine.counts()
        return [
            Piece(texts("bar.nodes", count=nodes), colours.bar),
            Piece(f" {self._look.glyphs.dot} {texts('bar.topics', count=topics)}", colours.bar),
        ]

    def _switches(self) -> list[Piece]:
        machine, texts = self._machine, self._look.texts
        colours, glyphs = self._look.colours, self._look.glyphs
        mark = glyphs.paused if machine.paused else glyphs.running
        times = "×" if glyphs.unicode else "x"
        pace = texts("bar.fastest") if machine.speed == math.inf else f"{machine.speed:g}{times}"
        speed = texts("bar.paused") if machine.paused else pace
        time_style = colours.hint if machine.paused else colours.bar
        language = f" {texts('bar.language')} " if self._look.chinese else ""
        return [
            Piece(language, colours.bar_muted, self._actions["language"]),
            Piece(f" {mark} {speed} ", time_style, self._actions["pause"]),
            Piece(f" {texts('bar.help')} ", colours.bar, self._actions["help"]),
        ]


def _nothing(short: bool) -> list[Piece]:
    return []
