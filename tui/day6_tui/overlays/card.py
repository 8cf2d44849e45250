"""The card of a message, over the panes: what it means, why here, what to type next (Enter types it), what a real robot does."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from textual.app import ComposeResult
from textual.binding import Binding
from textual.content import Content
from textual.widget import Widget

from day6_core.session.harmless import one_line
from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal

if TYPE_CHECKING:
    from day6_core.advice.explain import Explanation

LARGEST, FRAME = 84, 5
"""Columns of the card where there is room (as in `modal.tcss`), and those of its frame and its margins."""


def with_commands(lines: Iterable[str]) -> Iterator[Content]:
    """Lines of a text, what stands between ` as commands; one may go on in the next line."""
    inside = False
    for line in lines:
        content = Content("  ")
        for number, part in enumerate(one_line(line).split("`")):
            inside = inside != bool(number)
            content += Content.styled(part, "$panel-key") if inside else Content(part)
        yield content


class CardModal(Modal):
    """Shows an explanation. `type_next` types its command; F1 (the desktop's key) goes on to the manual."""

    BINDINGS = [
        Binding("enter", "type_next", show=False),
        Binding("down,j", "step(1)", show=False),
        Binding("up,k", "step(-1)", show=False),
        Binding("pagedown,space", "scroll(1)", show=False),
        Binding("pageup", "scroll(-1)", show=False),
        Binding("home", "edge(-1)", show=False),
        Binding("end", "edge(1)", show=False),
        Binding("q", "close", show=False),
    ]

    def __init__(self, look: Look, shown: Explanation, type_next: Callable[[str], object]) -> None:
        texts = look.texts
        super().__init__(look, texts("why.title"), texts("why.keys.next" if shown.next else "why.keys"))
        self._shown = shown
        self._type_next = type_next

    def inside(self) -> ComposeResult:
        from textual.containers import VerticalScroll
        from textual.widgets import Static

        self._text = Static(self._content(), classes="text")
        self._scroll = VerticalScroll(self._text)
        self._scroll.can_focus = False
        yield self._scroll
        if self._shown.next:
            yield Static(self._command(), classes="next")

    @property
    def keyboard(self) -> Widget | None:
        return None

    def on_resize(self) -> None:
        self._text.update(self._content())

    def _width(self) -> int:
        return max(20, min(self.app.size.width, LARGEST) - FRAME)

    def _content(self) -> Content:
        """All but the command. Broken into lines here: Textual takes a Chinese sentence for one long word."""
        from day6_core.advice.explain import parts, wrapped

        width = self._width()
        lines = [Content.styled(line, "bold $warning") for line in wrapped(self._shown.line, width)]
        for heading, text in parts(self._shown, self.look.texts.language):
            lines += [Content(""), Content.styled(heading, "bold $panel-strong")]
            lines += with_commands(wrapped(text, width - 2))
        return Content("\n").join(lines)

    def _command(self) -> Content:
        from day6_core.advice.explain import wrapped

        head = self.look.texts("why.next")
        lines = wrapped(one_line(self._shown.next), self._width() - 2)
        return Content("\n").join([Content(head), *(Content.styled(f"  {line}", "bold $panel-key") for line in lines)])

    def action_type_next(self) -> None:
        """Enter: type the command, which waits for the pupil's own Return; without one, close."""
        if not self.is_active:
            return
        self.close()
        if self._shown.next:
            self._type_next(self._shown.next)

    def action_step(self, step: int) -> None:
        """A line up or down."""
        self._scroll.scroll_relative(y=step, animate=False)

    def action_scroll(self, step: int) -> None:
        """As many lines as are seen."""
        self._scroll.scroll_relative(y=step * max(1, self._scroll.size.height - 1), animate=False)

    def action_edge(self, step: int) -> None:
        """The beginning or the end."""
        if step < 0:
            self._scroll.scroll_home(animate=False)
        else:
            self._scroll.scroll_end(animate=False)
