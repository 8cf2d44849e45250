"""The text of the lower bar: a notice, or the keys that work now."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from day6_core.speeds import in_words
from day6_tui.actions import Actions, bar_actions
from day6_tui.bars.bars import KeyHint, key_pieces
from day6_tui.features.scene_play import ScenePlay
from day6_tui.panes.cells import cell_len, clip
from day6_tui.panes.pane import Piece
from day6_tui.parts import Feature, Parts

SCENE_KEYS = 46
"""Cells for the keys that steer a scene."""


class KeyLine(Feature):
    """The keys of the focused pane before those of the desktop."""

    def __init__(self, parts: Parts, scenes: ScenePlay, actions: Actions, coming: Callable[[], bool]) -> None:
        super().__init__(parts)
        self._scenes = scenes
        self._actions = actions
        self._coming = coming
        """Whether the lessons were asked for and are not there yet."""
        self._made_of: tuple[object, ...] = ()
        self._made: list[Piece] = []
        """The keys as they were shown last, and what of: they are asked for many times before another one works."""

    def pieces(self, width: int) -> tuple[list[Piece], list[Piece]]:
        """From the left, as many as fit; nothing from the right."""
        look, texts = self._look, self._look.texts
        if self._notices.text:
            return [Piece(f" {self._notices.text} ", look.colours.hint)], []
        if self._coming():
            return [Piece(f" {texts('lesson.coming')} ", look.colours.hint)], []
        if self._scenes.player is not None:
            return self._scene(width), []
        pane = self._desktop.focused_pane
        hints, weight = (pane.key_hints(), pane.key_weight) if pane is not None else ([], 0)
        keys = [KeyHint(*hint) if hint is hints[0] else KeyHint(*hint, weight=weight) for hint in hints]
        for action in bar_actions():
            name = "action.resume" if action.id == "pause" and self._machine.paused else f"action.{action.id}"
            weight = action.weight if hints else action.alone or action.weight
            keys.append(KeyHint(action.label, texts(name), self._actions[action.id], weight))
        if (made_of := (keys, width, look.colours)) != self._made_of:
            self._made_of, self._made = made_of, key_pieces(look, keys, width)
        return self._made, []

    def _scene(self, width: int) -> list[Piece]:
        """What is typed and how to steer it: pause, step, the speed between its two buttons, stop."""
        look, texts, scenes, glyphs = self._look, self._look.texts, self._scenes, self._look.glyphs
        steering, paused = scenes.steering, scenes.steering.held
        head = texts("bar.scene.paused" if paused else "bar.playing")
        if scenes.said:
            head = clip(scenes.said, max(cell_len(head), width - SCENE_KEYS), glyphs.ellipsis)
        pieces = [Piece(f" {head} ", look.colours.hint)]
        pause = KeyHint("F9", texts("bar.scene.resume" if paused else "bar.scene.pause"), steering.hold)
        keys = [
            pause,
            KeyHint("PgDn", texts("bar.scene.step"), steering.step),
            KeyHint("Esc", texts("bar.scene.stop"), scenes.stop),
        ]
        speed = [
            Piece(" - ", look.colours.key, partial(steering.change_speed, -1)),
            Piece(f" {in_words(steering.speed, unicode=glyphs.unicode)} ", look.colours.bar_strong),
            Piece(" + ", look.colours.key, partial(steering.change_speed, 1)),
            Piece("  ", look.colours.bar),
        ]
        room = width - sum(cell_len(piece.text) for piece in (*pieces, *speed)) - 1
        return [*pieces, Piece(" ", look.colours.bar), *speed, *key_pieces(look, keys, max(0, room))]
