"""Which picture is where on the screen: the one object of an application that writes them.

A pane keeps blank cells under its picture and hands the pixels over. What is sent are the bands of cells that changed, after
the text of the same frame, as one write. What is behind something else (`covers_of`), and cells of text in the picture, are left
out. Behind every write the terminal is asked whether it is ready, and no new picture is sent before it is: so a slow link or
terminal gets fewer pictures, then coarser ones, and at last characters again. Where text and picture no longer fit together,
that is mended at once.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from textual.errors import NoWidget
from textual.geometry import Region
from textual.widget import Widget

from day6_tui.appearance.glyphs import GLYPH_SETS, PIXELS
from day6_tui.appearance.look import Look
from day6_tui.pixels.ask import FIRST, IS_READY, ITERM, KITTY, READY, Ability, Inquiry, closes
from day6_tui.textual_private.access import SYNC_END, SYNC_START
from day6_tui.textual_private.frame_screen import covers_of

if TYPE_CHECKING:
    from textual.strip import Strip

    from day6_tui.pixels.bands import Array, BandPiece, Writer

MOST_PIXELS = 700_000
"""Of one picture; a larger pane has coarser ones."""

BAND_PIXELS = 40
"""About the height of a band."""

SLOW_SECONDS = 0.6
"""An answer that takes longer, several times in a row, is one too slow for pictures of this size."""
SLOW_ANSWERS = 3
QUICK_ANSWERS = 100
"""So many quick answers in a row allow finer pictures again."""
LOST_SECONDS = 4.0
"""After this there will be no answer."""
COARSEST = 2


_NOWHERE = Region()


@dataclass(eq=False)
class _Picture:
    place: Region
    """In the pane, in cells."""
    cell: tuple[int, int]
    pixels: Array
    holes: tuple[Region, ...]
    """Cells of text, counted from the picture's corner."""
    first_band: int
    rows: int
    """Rows of cells of a band."""
    sent: Array | None = None
    region: Region = _NOWHERE
    """On the screen, as it was sent."""
    visible: list[Region] = field(default_factory=list)
    """What was to be seen of it then."""
    pieces: dict[int, list[BandPiece]] = field(default_factory=dict)
    """The visible pieces of every band, as sent."""
    damaged: list[Region] = field(default_factory=list)
    """Cells of the screen that text has overwritten since."""

    @property
    def bands(self) -> range:
        return range(self.first_band, self.first_band + -(-self.place.height // self.rows))

    def is_hurt(self, visible: list[Region]) -> bool:
        """Whether text has wiped what was sent, or what was sent may lie over text: the picture, or what covers it, moved."""
        return visible != self.visible or any(each.overlaps(part) for each in self.damaged for part in visible)


class Pictures:
    """Asks the terminal what it can, and writes the panes' pictures through `write`."""

    def __init__(
        self,
        look: Look,
        environ: Mapping[str, str],
        write: Callable[[str], object],
        *,
        changed: Callable[[], object],
        given_up: Callable[[], object] = lambda: None,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._look = look
        self._environ = environ
        self._write = write
        self._changed = changed
        """Called when pictures can be shown from now on, or no longer."""
        self._given_up = given_up
        """Called when the terminal is too slow for pictures."""
        self._clock = clock
        self._inquiry: Inquiry | None = None
        self._inquired_at = 0.0
        self._ask_next: tuple[tuple[int, int], tuple[int, int]] | None = None
        """The sizes to ask with when the present inquiry is over: answers do not say to which of two they belong."""
        self.ability: Ability | None = None
        self.wanted = False
        """Whether pixels are chosen as soon as the terminal is known to show them."""
        self._writer: Writer | None = None
        self._pictures: dict[Widget, _Picture] = {}
        self._bands = 0
        self.coarser = 0
        """How many times pictures were made coarser for a slow terminal."""
        self.stopped = False
        """Whether the application leaves: only `farewell` changes anything from here on."""
        self.asked = 0
        self._answered = 0
        self._asked_at = self._heard_at = 0.0
        self._slow = self._quick = 0

    # -- the terminal --------------------------------------------------------------------------------------------------

    def ask(self, size: tuple[int, int], pixels: tuple[int, int] = (0, 0)) -> None:
        """Ask what the terminal can; `size` of the screen in cells, `pixels` if the system knows them."""
        if self._inquiry is not None and self._clock() - self._inquired_at < LOST_SECONDS:
            self._ask_next = size, pixels
            return
        self._ask_next, self._inquired_at = None, self._clock()
        self._inquiry = Inquiry(self._environ, size, pixels)
        self._put(FIRST)

    def use(self, ability: Ability) -> None:
        """Draw in this way, without asking."""
        if self._writer is not None and (text := self._writer.erase_all()):
            self._write(text)
        first, self.ability = self.ability is None, ability
        self._writer = None
        self._pictures.clear()  # they come again, in other bands
        if first and self.wanted:
            self._look.glyphs = GLYPH_SETS[PIXELS]
        self._changed()

    def hear(self, answer: str) -> None:
        """An answer was read; called at once, in the thread that reads the terminal."""
        if closes(answer):
            self._answered += 1
            self._heard_at = self._clock()

    def take(self, answer: str) -> None:
        """An answer has come to the application."""
        if answer == IS_READY:
            if self._answered == self.asked:  # else this is not the last question's
                self._measure(self._heard_at - self._asked_at)
            self.send()
        elif self._inquiry is not None:
            if question := self._inquiry.take(answer):
                self._put(question)
            elif self._inquiry.done:
                ability, self._inquiry = self._inquiry.ability, None
                if self._ask_next is not None:
                    self.ask(*self._ask_next)
                elif ability is not None and ability != self.ability:
                    self.use(ability)

    @property
    def waiting(self) -> bool:
        """Whether the terminal has something to answer still."""
        return self._answered < self.asked and self._clock() - self._asked_at < LOST_SECONDS

    def _put(self, question: str) -> None:
        if not self.waiting:
            self._answered = self.asked  # what has not been answered by now is lost
        self.asked += 1
        self._asked_at = self._clock()
        self._write(question)

    def _measure(self, seconds: float) -> None:
        self._slow = self._slow + 1 if seconds > SLOW_SECONDS else 0
        self._quick = self._quick + 1 if seconds < SLOW_SECONDS / 4 else 0
        if self._quick >= QUICK_ANSWERS and self.coarser:
            self._quick = 0
            self.coarser -= 1
        if self._slow >= SLOW_ANSWERS:
            self._slow = 0
            if self.coarser < COARSEST:
                self.coarser += 1
            else:
                self._give_up()

    def _give_up(self) -> None:
        """Characters again; the user may choose pixels once more."""
        self.coarser = self._slow = 0
        self._look.glyphs = GLYPH_SETS["half"]
        self._changed()
        self._given_up()

    # -- what panes ask ------------------------------------------------------------------------------------------------

    @property
    def on(self) -> bool:
        """Whether panes should draw with pixels."""
        return self.ability is not None and self._look.glyphs.name == PIXELS

    @property
    def any(self) -> bool:
        """Whether a pane has a picture."""
        return bool(self._pictures)

    def cell(self, columns: int, rows: int, most: int = MOST_PIXELS) -> tuple[int, int]:
        """Pixels across and down in a cell of a picture of this size."""
        width, height = self.ability.cell if self.ability is not None else (1, 2)
        across, down, part = width, height, 1
        while part <= self.coarser or (columns * rows * across * down > most and across > 2):
            part += 1
            across, down = max(1, round(width / part)), max(1, round(height / part))
        return across, down

    def show(
        self, pane: Widget, place: Region, cell: tuple[int, int], pixels: Array, holes: Iterable[Region] = ()
    ) -> None:
        """Show a picture at `place` of a pane (in cells), from the next frame on; `holes` of it are left to text."""
        old = self._pictures.get(pane)
        if old is not None and old.place.size == place.size:
            if old.cell != cell:
                old.cell, old.sent = cell, None
            old.place, old.pixels, old.holes = place, pixels, tuple(holes)
            return
        if old is not None:
            self._erase(old)
        rows = place.height
        if self.ability is not None and self.ability.exact is None:
            rows = max(1, BAND_PIXELS // self.ability.cell[1])
        self._pictures[pane] = picture = _Picture(place, cell, pixels, tuple(holes), self._bands, rows)
        self._bands += len(picture.bands)

    def drop(self, pane: Widget) -> None:
        """The pane has no picture any more."""
        if (picture := self._pictures.pop(pane, None)) is not None:
            self._erase(picture)

    def drawn_over(self, strips: list[Strip]) -> list[Strip]:
        """The lines of the screen with the pictures in them, as half blocks."""
        from day6_tui.pixels.halves import halved, over

        for pane, picture in self._pictures.items() if self.on else ():
            if pane.is_attached and (visible := self._visible(pane, picture)):
                halves = halved(picture.pixels, picture.cell)
                strips = over(strips, (picture.region.x, picture.region.y), visible, halves)
        return strips

    # -- writing -------------------------------------------------------------------------------------------------------

    def displayed(self, update: Any) -> None:
        """Textual has drawn: what it drew over is drawn again, now."""
        if not self._pictures:
            return
        spans = getattr(update, "spans", None)
        whole = [getattr(update, "region", Region(0, 0, 10_000, 10_000))]
        drawn = whole if spans is None else [Region(x1 - 1, y, x2 - x1 + 2, 1) for y, x1, x2 in spans]
        for picture in self._pictures.values():
            picture.damaged += [each for each in drawn if picture.region.overlaps(each)]
        self.send()

    def send(self) -> None:
        """Write what changed; while the terminal is busy with what was sent before, only pictures that text has hurt."""
        if not self._pictures or self.stopped:
            return
        texts, is_busy = [], self.waiting
        is_asked = not is_busy
        for pane, picture in list(self._pictures.items()):
            if not pane.is_attached:
                self.drop(pane)
            elif visible := self._visible(pane, picture) if self.on else []:
                if not is_busy:
                    texts.append(self._drawn(picture, visible, picture.pixels))
                elif picture.is_hurt(visible):  # mended with what the terminal has: new pixels wait for its answer
                    is_asked = is_asked or picture.sent is None
                    texts.append(
                        self._drawn(picture, visible, picture.pixels if picture.sent is None else picture.sent)
                    )
            elif picture.sent is not None:
                self._erase(picture)
        if any(texts):
            text = f"{SYNC_START}\x1b7{''.join(texts)}\x1b8{SYNC_END}"
            if is_asked:
                self._put(text + READY)
            else:
                self._write(text)  # what was asked before is still to be answered

    def _visible(self, pane: Widget, picture: _Picture) -> list[Region]:
        """The parts of the screen on which a picture is to be seen; its region is brought up to date."""
        from day6_tui.pixels.bands import without

        try:
            geometry = pane.screen.find_widget(pane)
        except NoWidget:
            return []
        region = picture.place.translate(geometry.region.offset)
        seen = region.intersection(geometry.clip)
        if not seen:
            return []
        if region != picture.region:
            picture.region, picture.sent = region, None
        holes = [hole.translate(region.offset) for hole in picture.holes]
        return without(seen, [*covers_of(pane), *holes])

    def _drawn(self, picture: _Picture, visible: list[Region], shown: Array) -> str:
        from day6_tui.pixels.bands import changed_cells, pieces_of

        writer, sent, across = self._writer_of(), picture.sent, picture.place.width
        texts = []
        for band in picture.bands:
            top = (band - picture.first_band) * picture.rows
            region = Region(
                picture.region.x, picture.region.y + top, across, min(picture.rows, picture.place.height - top)
            )
            lines = slice(top * picture.cell[1], (top + region.height) * picture.cell[1])
            pixels, changed = shown[lines], Region(0, 0, *region.size)
            if sent is not None:
                changed = changed_cells(sent[lines], pixels, picture.cell)
            stale = [each.intersection(region) for each in picture.damaged if each.overlaps(region)]
            if changed:
                stale.append(changed.translate(region.offset))
            pieces = pieces_of(region, visible)
            if writer.keeps:
                due = bool(stale) or pieces != picture.pieces.get(band)
                picture.pieces[band] = pieces
            else:
                due = bool(stale)
                box = (region if writer.seams else Region.from_union(stale)) if due else Region()
                pieces = pieces_of(region, [each.intersection(box) for each in visible if each.overlaps(box)])
            if due:
                texts.append(writer.draw(band, pixels, picture.cell, pieces, bool(changed)))
        picture.sent, picture.visible, picture.damaged = shown, visible, []
        return "".join(texts)

    def _writer_of(self) -> Writer:
        if self._writer is None:
            assert self.ability is not None
            self._writer = _writer(self.ability)
        return self._writer

    def _erase(self, picture: _Picture) -> None:
        """Take a picture from the screen; its cells are blank below."""
        if self.stopped:
            return
        if self._writer is not None and (text := self._writer.erase(picture.bands)):
            self._write(text)
        picture.sent = None

    def farewell(self) -> str:
        """What removes everything of ours from the terminal. Pictures are sent anew after that."""
        text = self._writer.erase_all() if self._writer is not None else ""
        self._forget()
        self._answered = self.asked
        return text

    def _forget(self) -> None:
        self._writer = None
        for picture in self._pictures.values():
            picture.sent = None


def _writer(ability: Ability) -> Writer:
    if ability.protocol == KITTY:
        from day6_tui.pixels.kitty import Kitty

        return Kitty()
    if ability.protocol == ITERM:
        from day6_tui.pixels.iterm import ITerm

        return ITerm()
    from day6_tui.pixels.sixel import Sixel

    return Sixel(ability.exact or ability.cell)
