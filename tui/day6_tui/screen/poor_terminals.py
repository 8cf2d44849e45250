"""Textual's widgets on terminals that lack characters or colour: their texts and scroll bars are drawn with what there is."""

from __future__ import annotations

from rich.segment import Segment, Segments
from rich.style import Style
from textual.color import Color
from textual.filter import LineFilter, NoColor
from textual.scrollbar import ScrollBarRender

from day6_tui.appearance.characters import in_ascii
from day6_tui.appearance.look import Look


class WholeCells(ScrollBarRender):
    """Made of whole coloured cells: for fonts without the eighths of a block."""

    VERTICAL_BARS = [" "] * 8
    HORIZONTAL_BARS = [" "] * 8


class OfCharacters(WholeCells):
    """A scroll bar of characters, which can be seen without colour too."""

    @classmethod
    def render_bar(cls, *args: object, **options: object) -> Segments:
        bar = super().render_bar(*args, **options)  # type: ignore[arg-type]
        drawn = []
        for text, style, control in bar.segments:
            thumb = style is not None and bool(style.reverse)
            plain = (style + Style(reverse=False)) if style is not None and thumb else style
            drawn.append(Segment(text.replace(" ", "#" if thumb else "|"), plain, control))
        return Segments(drawn, new_lines=bar.new_lines)


def renderer_for(look: Look) -> type[ScrollBarRender]:
    """What `ScrollBar.renderer` must be for these glyphs."""
    if not look.glyphs.unicode:
        return OfCharacters
    return ScrollBarRender if look.glyphs.chinese else WholeCells


class AsciiOnly(LineFilter):
    """Replaces what the set 'ascii' rules out, as in our own panes: drawings, and `letters` or not."""

    def __init__(self, *, letters: bool) -> None:
        super().__init__()
        self._letters = letters

    def apply(self, segments: list[Segment], background: Color) -> list[Segment]:
        return list(in_ascii(segments, letters=self._letters))


_ASCII_ONLY = {letters: AsciiOnly(letters=letters) for letters in (False, True)}
"""One of each: Textual remembers lines by their filters."""
_NO_COLOUR = NoColor()


def filters_for(look: Look) -> list[LineFilter]:
    """What the lines of Textual's widgets have to go through."""
    plain = [] if look.glyphs.unicode else [_ASCII_ONLY[look.letters]]
    return [*plain, *look.filters, *([_NO_COLOUR] if look.colours.colourless else [])]
