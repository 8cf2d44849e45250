"""The console's line to type in: a text by which messages are left out or stand out, in force while it is typed."""

from __future__ import annotations

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding
from textual.containers import Horizontal
from textual.widgets import Static

from day6_tui.appearance.look import Look
from day6_tui.overlays.input_line import InputLine
from day6_tui.overlays.modal import plain
from day6_tui.textual_private.survival import PersonMessage, Surviving


class ConsoleLine(Surviving, Horizontal):
    """The name of what is typed, and the line; nothing of it is seen until `open`."""

    messages_are_typed = True

    class Typed(PersonMessage):
        """The text changed, or what it is; `done` if the user is ready with it."""

        def __init__(self, line: ConsoleLine, text: str, *, is_regex: bool, done: bool) -> None:
            super().__init__()
            self.line, self.text, self.is_regex, self.done = line, text, is_regex, done

        @property
        def control(self) -> ConsoleLine:
            return self.line

    class Field(InputLine):
        """Textual's Input; Enter, Tab and Esc are its owner's."""

        BINDINGS = [Binding("escape", "leave", show=False), Binding("tab", "switch", show=False)]

        async def action_submit(self) -> None:
            """Enter: what is typed stays."""
            self.owner.leave(self.value)

        def action_leave(self) -> None:
            """Esc: what was there before comes back."""
            self.owner.is_regex = self.owner.was_regex
            self.owner.leave(self.owner.before)

        def action_switch(self) -> None:
            """Tab: a regular expression, or a text again."""
            self.owner.switch()

        def on_blur(self, event: events.Blur) -> None:
            """A click elsewhere: as Enter."""
            self.owner.leave(self.value)

        @property
        def owner(self) -> ConsoleLine:
            assert isinstance(self.parent, ConsoleLine)
            return self.parent

    def __init__(self, look: Look) -> None:
        super().__init__()
        self.purpose = ("", 0)
        """The side and place of the filter that the text is for."""
        self.before = ""
        self.is_regex = self.was_regex = False
        """Whether the text is a regular expression; whether it was one before."""
        self._titles = ("", "")
        self._purpose_name = Static()
        self.field = self.Field(look)
        self.display = False

    def compose(self) -> ComposeResult:
        yield self._purpose_name
        yield self.field

    def open(self, purpose: tuple[str, int], titles: tuple[str, str], note: str, text: str, *, is_regex: bool) -> None:
        """Ask for a text, beginning with the one that is in force. `titles`: of a text, and of a regular expression."""
        self.purpose, self.before, self._titles = purpose, text, titles
        self.is_regex = self.was_regex = is_regex
        self._purpose_name.update(plain(titles[is_regex]))
        self.field.placeholder = note
        with self.field.prevent(self.field.Changed):
            self.field.value = text
        self.field.cursor_position = len(text)
        self.display = True
        self.screen.set_focus(self.field, scroll_visible=False)

    def switch(self) -> None:
        """Take the text for a regular expression, or for a text again."""
        self.is_regex = not self.is_regex
        self._purpose_name.update(plain(self._titles[self.is_regex]))
        self.post_message(self.Typed(self, self.field.value, is_regex=self.is_regex, done=False))

    def leave(self, text: str) -> None:
        """Be ready, with this text."""
        if self.display:
            self.display = False
            self.post_message(self.Typed(self, text, is_regex=self.is_regex, done=True))

    def on_input_changed(self, event: InputLine.Changed) -> None:
        event.stop()
        if self.display:
            self.post_message(self.Typed(self, event.value, is_regex=self.is_regex, done=False))
