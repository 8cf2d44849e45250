"""The desktop's current appearance: glyphs, colours, language. One object, shared by all panes and changed in place."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from day6_tui.appearance.colours import Colours
from day6_tui.appearance.glyphs import GlyphSet
from day6_tui.locale import Texts

if TYPE_CHECKING:
    from textual.filter import LineFilter

    from day6_tui.pixels.pictures import Pictures


@dataclass
class Look:
    """Panes read it whenever they draw; the code that changes it makes them redraw everything."""

    glyphs: GlyphSet
    colours: Colours
    texts: Texts
    letters: bool = True
    """Whether the terminal takes letters that are not ASCII: then the set 'ascii' is one of drawings only."""
    chinese: bool = True
    """Whether the terminal is thought to have Chinese characters, so that this language is offered."""
    alt: bool = True
    """Whether the terminal sends Alt with a key, so that hints may name such keys."""
    remark: str = ""
    """The text that says why the language isn't the one that was asked for; '' if it is."""
    reduced_motion: bool = False
    wake: Callable[[], None] = field(default=lambda: None)
    """Requests a frame: for panes whose size or state the user changed."""
    wake_after: Callable[[float], None] = field(default=lambda seconds: None)
    """Requests one in so many seconds even if nothing changes until then; every `pull` has to ask anew."""
    work_soon: Callable[[], None] = field(default=lambda: None)
    """Asks that output which programs wait with is read before the next frame. Any thread."""
    filters: Sequence[LineFilter] = ()
    """What every line has to go through for this terminal, after the characters: fewer colours."""
    pictures: Pictures | None = None
    """What writes pictures of real pixels, where the application has a terminal."""

    def hint(self, key: str) -> str:
        """Return how a key is named in hints; '' if this terminal doesn't send it."""
        return key if self.alt or "Alt+" not in key else ""

    @property
    def pixels(self) -> Pictures | None:
        """What writes pictures while panes should draw with pixels, else None."""
        return self.pictures if self.pictures is not None and self.pictures.on else None

    @property
    def has_shades(self) -> bool:
        """Whether the terminal has more than the sixteen colours of its own, or any at all."""
        return not self.colours.colourless and self.colours.name != "sixteen"
