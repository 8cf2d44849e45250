"""Textual's scroll bars in the colours and characters of the desktop."""

from __future__ import annotations

from textual.color import Color
from textual.scrollbar import ScrollBar
from textual.widget import Widget

from day6_tui.appearance.look import Look
from day6_tui.screen.poor_terminals import renderer_for


def colour_scrollbar(widget: Widget, look: Look) -> None:
    """Give a widget's scroll bar the colours of the frames, and all of them the characters that the terminal shows."""
    ScrollBar.renderer = renderer_for(look)
    thumb, track = look.colours.frame.color, look.colours.frame.bgcolor
    if thumb is not None and track is not None:
        styles, bar, behind = widget.styles, Color.from_rich_color(thumb), Color.from_rich_color(track)
        styles.scrollbar_color = styles.scrollbar_color_hover = styles.scrollbar_color_active = bar
        styles.scrollbar_background = styles.scrollbar_background_hover = styles.scrollbar_background_active = behind
