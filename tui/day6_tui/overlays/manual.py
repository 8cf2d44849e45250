"""F1: the manual. It opens at the page of the focused pane, with its keys first; typing searches all pages."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from textual.app import ComposeResult
from textual.binding import Binding

from day6_core.language import LANGUAGES
from day6_tui.appearance.look import Look
from day6_tui.locale import catalogue
from day6_tui.overlays.menu import MenuEntry, SearchedList
from day6_tui.overlays.modal import plain
from day6_tui.panes.cells import fit, wrap
from day6_tui.panes.pane import Pane

if TYPE_CHECKING:
    from textual.widgets import OptionList

KEY_WIDTH = 12
"""Cells for the keys in a list of them."""

WIDE = 100
"""Columns from which the pages are listed beside the page."""

LARGEST, LIST_WIDTH = 100, 24
"""Columns of the manual, where there is room, and of the list in it: as in `modal.tcss`."""

_PUNCTUATION = re.compile(r"([!-/:-@\[-`{-~])")


def pages() -> list[str]:
    """The pages in their order: the texts `manual.<page>` are their titles, `help.<page>` what they say."""
    return [page for prefix, _, page in (key.partition(".") for key in catalogue("en")) if prefix == "manual"]


def escaped(text: str) -> str:
    """Text that means itself in Markdown."""
    return _PUNCTUATION.sub(r"\\\1", text)


def with_code(lines: Iterable[str]) -> list[str]:
    """Lines as Markdown; what stands between ` stays code, and may go on in the next line."""
    found, inside = [], False
    for line in lines:
        parts = []
        for number, part in enumerate(line.split("`")):
            inside = inside != bool(number)
            parts.append(f"`{part}`" if inside and part else escaped(part))
        found.append("".join(parts))
    return found


def key_list(keys: Iterable[tuple[str, str]], width: int) -> str:
    """A paragraph of Markdown with a line for each key and what it does, in lines of at most `width` cells."""
    lines = []
    for key, name in keys:
        heads = (f"`` {fit(key, KEY_WIDTH)} ``", f"`{' ' * KEY_WIDTH}`")
        lines += [heads[min(at, 1)] + escaped(line) for at, line in enumerate(wrap(name, width - KEY_WIDTH))]
    return "  \n".join(lines)


def page_of(text: str, width: int) -> str:
    """A help text as Markdown; its lines with a tab are keys with what they do.

    Broken into lines here, because Textual takes a Chinese sentence for one long word.
    """
    blocks: list[str] = []
    for block in text.split("\n\n"):
        lines = block.split("\n")
        words = with_code(part for line in lines if "\t" not in line for part in wrap(line, width))
        keys = [(key, name) for key, tab, name in (line.partition("\t") for line in lines) if tab]
        blocks += ["  \n".join(words)] if words else []
        blocks += [key_list(keys, width)] if keys else []
    return "\n\n".join(blocks)


class Manual(SearchedList):
    """All help texts; `pane` decides which is shown at first, `everywhere` are the keys that belong to no pane."""

    BINDINGS = [
        Binding("down", "step(1)", show=False),
        Binding("up", "step(-1)", show=False),
        Binding("tab", "turn(1)", show=False),
        Binding("shift+tab", "turn(-1)", show=False),
        Binding("pagedown", "scroll(1)", show=False),
        Binding("pageup", "scroll(-1)", show=False),
    ]

    def __init__(self, look: Look, pane: Pane | None, everywhere: Sequence[tuple[str, str]]) -> None:
        texts = look.texts
        self._pages = pages()
        entries = [
            MenuEntry(
                texts(key), "", lambda: None, also=[catalogue(language)[key] for language in LANGUAGES], words=words
            )
            for key, words in ((f"manual.{page}", texts(f"help.{page}")) for page in self._pages)
        ]
        super().__init__(look, texts("help.title"), texts("help.keys"), entries)
        self._own = pane.help_key if pane is not None else self._pages[0]
        self._hints = [*pane.key_hints(), *pane.more_key_hints()] if pane is not None else []
        self._everywhere = everywhere
        self._open = self._pages.index(self._own) if self._own in self._pages else 0

    def inside(self) -> ComposeResult:
        from textual.containers import Container, VerticalScroll
        from textual.widgets import Markdown

        self.set_class(self.app.size.width >= WIDE, "-wide")
        self._drawn_width = self._width()
        self._make_widgets(self.look.texts("help.search"), id="pages")
        yield self._line
        self._markdown = Markdown(self.markdown(), open_links=False)
        self._page = VerticalScroll(self._markdown, id="page")
        self._page.can_focus = False
        with Container(id="book"):
            yield self._list
            yield self._page
        self._show(self._entries, self._open)

    def on_resize(self) -> None:
        self.set_class(self.app.size.width >= WIDE, "-wide")
        if self._width() != self._drawn_width:
            self._drawn_width = self._width()
            self._markdown.update(self.markdown())

    # -- pages ---------------------------------------------------------------------------------------------------------

    def markdown(self) -> str:
        """The open page: the keys of the focused pane if it is its page, the text, and the keys that work everywhere."""
        texts, page, width = self.look.texts, self._pages[self._open], self._width()
        parts = [key_list(self._hints, width)] if page == self._own and self._hints else []
        parts.append(page_of(texts(f"help.{page}"), width))
        parts += [f"**{escaped(texts('help.everywhere'))}**", key_list(self._everywhere, width)]
        return "\n\n".join(parts)

    def _width(self) -> int:
        """Cells of a line of the page."""
        columns = self.app.size.width
        return min(columns, LARGEST) - (LIST_WIDTH if columns >= WIDE else 0) - 5

    def open_page(self, index: int) -> None:
        """Show a page from its beginning."""
        if index != self._open:
            self._open = index
            self._markdown.update(self.markdown())
            self._page.scroll_home(animate=False)
        self._name_page()

    def _name_page(self) -> None:
        name = f"{self.look.texts('help.title')}: {self._entries[self._open].name}"
        self.query_one("#frame").border_title = plain(name)

    # -- searching -----------------------------------------------------------------------------------------------------

    def on_mount(self) -> None:
        super().on_mount()
        self._name_page()

    def _show(self, entries: list[MenuEntry], chosen: int) -> None:
        self.set_class(bool(self._typed), "-searching")
        super()._show(entries, chosen if self._typed else self._open)

    def on_option_list_option_highlighted(self, event: OptionList.OptionHighlighted) -> None:
        if event.option_index < len(self._matches):
            self.open_page(self._entries.index(self._matches[event.option_index]))

    def action_turn(self, step: int) -> None:
        """The next or previous of the pages that are listed."""
        self.move(step)

    def action_step(self, step: int) -> None:
        """A line of the page; while searching, a page."""
        self.matches()
        if self._typed:
            self.action_turn(step)
        else:
            self._page.scroll_relative(y=step, animate=False)

    def action_scroll(self, step: int) -> None:
        """As many lines as are seen."""
        self._page.scroll_relative(y=step * max(1, self._page.size.height - 1), animate=False)

    def accept(self) -> None:
        """Enter: read what was found; close the manual if nothing was searched."""
        self.matches()
        if self._typed:
            self._line.value = ""
        else:
            self.close()
