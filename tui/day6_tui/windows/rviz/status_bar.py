"""The text below the picture: a message, what is being loaded, the chosen line in full, or a description of the view."""

from __future__ import annotations

import time

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.properties import STATUS
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import clip, wrap
from day6_tui.windows.rviz import panel
from day6_tui.windows.rviz.describing import described
from day6_tui.windows.rviz.tree import PropertyTree
from day6_tui.windows.rviz.view import View3D

SECONDS_BETWEEN_TEXTS = 0.5
"""Minimum seconds between two texts, so that each can be read."""


class StatusBar:
    """Holds the lines of text, and the frame rate that is shown beside them."""

    def __init__(self, rviz: RViz, tree: PropertyTree, view: View3D, look: Look) -> None:
        self._rviz = rviz
        self._tree = tree
        self._view = view
        self._look = look
        self._made_at = -10.0
        self._seen: tuple[object, ...] = ()
        self._message, self._message_until = "", 0.0
        self.lines: list[str] = []
        self.rate = 0
        """Pictures a second."""

    def show_message(self, text: str, seconds: float = 4.0) -> None:
        """Show a message for a while, as `QStatusBar.showMessage` does."""
        self._message, self._message_until = text, time.monotonic() + seconds
        self.hurry()
        self._look.wake()

    @property
    def pressing(self) -> bool:
        """Whether it answers what somebody did, or tells what happens at the moment."""
        return bool(self._message or self._rviz.progress or self._rviz.message is not None)

    def hurry(self) -> None:
        """Do not wait with the next sentence: the user did something."""
        self._made_at = -10.0

    def forget(self) -> None:
        """Make the lines again: the appearance changed."""
        self.lines = []

    def pull(self, now: float, width: int, most: int, *, on_panel: bool) -> tuple[bool, bool]:
        """Make at most `most` lines of `width` cells; return whether they changed, and whether they may change soon.

        `on_panel`: the panel has the focus, so its chosen line is explained.
        """
        rviz = self._rviz
        state = (rviz.version, rviz.tree_version, self._tree.prop, on_panel, rviz.message, rviz.progress)
        waiting = now < self._message_until
        if state == self._seen and self.lines and not waiting and not self._message:
            return False, False
        if now - self._made_at < SECONDS_BETWEEN_TEXTS and self.lines:
            return False, True
        if not waiting:
            self._message = ""
        self._made_at, self._seen = now, state
        self.rate = round(self._view.rate)
        before, self.lines = self.lines, self._lines(self.sentence(on_panel=on_panel), width, most)
        return self.lines != before, waiting

    def _lines(self, sentence: str, width: int, most: int) -> list[str]:
        lines = wrap(sentence, max(10, width))
        if len(lines) > most:
            cut = lines[most - 1] + " " + lines[most]
            lines = [*lines[: most - 1], clip(cut, width, self._look.glyphs.ellipsis)]
        return lines

    def sentence(self, *, on_panel: bool) -> str:
        """The text to show now."""
        text = self._sentence(on_panel)
        return text if self._look.glyphs.unicode else in_ascii(text)

    def _sentence(self, on_panel: bool) -> str:
        rviz, texts = self._rviz, self._look.texts
        if self._message:
            return self._message
        if rviz.progress:
            return texts("rviz.loading", what=rviz.progress)
        if rviz.message is not None:
            key, parameters = rviz.message
            return texts(key, **parameters)
        if on_panel and (text := self._chosen_text()):
            return text
        return described(rviz, texts)

    def _chosen_text(self) -> str:
        """The chosen line in full if the panel cuts it, or what its display lacks."""
        prop = self._tree.prop
        if prop is None:
            return ""
        if hint := self._topic_hint():
            return hint
        if prop.kind == STATUS or isinstance(prop, Display):
            return panel.full_text(prop)
        return ""

    def _topic_hint(self) -> str:
        """How to give the chosen display a topic, if it has none."""
        display = self._tree.chosen_display
        topic = getattr(display, "topic", None)  # some kinds of displays have one
        if display is None or not display.enabled or topic is None or topic.hidden or topic.value:
            return ""
        options = ", ".join(list(topic.options)[:3])
        if options:
            return self._look.texts("rviz.hint.topic", name=topic.name, options=options)
        return self._look.texts("rviz.hint.no_topic", name=topic.name)


def in_ascii(text: str) -> str:
    """Return a text for a terminal that has only ASCII characters."""
    for char, plain in (("×", "x"), ("⌀", "d "), ("°", " deg"), ("…", "...")):
        text = text.replace(char, plain)
    return text
