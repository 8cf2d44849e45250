"""A question with a button for each answer; each has its key. Esc (`back`) leaves everything as it was."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from textual import events
from textual.app import ComposeResult
from textual.binding import Binding
from textual.content import Content
from textual.widget import Widget

from day6_tui.appearance.look import Look
from day6_tui.overlays.modal import Modal, lines_of, plain
from day6_tui.panes.cells import cell_len

if TYPE_CHECKING:
    from textual.widgets import Button


class Answer(NamedTuple):
    """A button: its letter, its label, what it does."""

    key: str
    label: str
    do: Callable[[], object]


class Question(Modal):
    """Asks `text`. The first answer is chosen at first; with `careful` it is the one that changes nothing."""

    BINDINGS = [
        Binding("right,down,tab", "app.focus_next", show=False),
        Binding("left,up,shift+tab", "app.focus_previous", show=False),
    ]

    waits = True

    def __init__(
        self, look: Look, title: str, text: str, answers: Sequence[Answer], *, careful: bool = False, back: str = ""
    ) -> None:
        super().__init__(look, title)
        self._back = back or look.texts("question.back")
        self._text = text
        self._answers = answers
        self._careful = careful
        self._keys_of = {answer.key: answer for answer in answers}

    def inside(self) -> ComposeResult:
        from textual.containers import Container
        from textual.widgets import Button, Static

        yield Static(Content("\n").join(lines_of(self._text)), classes="text")
        back = Button(plain(f"Esc {self._back}"), compact=True, id="back")
        buttons = [
            Button(plain(f"{answer.key.upper()} {answer.label}"), compact=True, name=answer.key)
            for answer in self._answers
        ]
        self._buttons = [*buttons, back]
        width = sum(cell_len(str(button.label)) + 3 for button in self._buttons)
        self.set_class(width > min(62, self.app.size.width - 2), "-narrow")
        yield Container(*self._buttons, id="answers")

    @property
    def keyboard(self) -> Widget:
        return self._buttons[-1 if self._careful else 0]

    def on_key(self, event: events.Key) -> None:
        answer = self._keys_of.get((event.character or "").lower())
        if answer is not None:
            event.stop()
            self._give(answer)
        elif event.character == "n":  # what people press who want to go back
            event.stop()
            self.close()

    def on_button_pressed(self, event: Button.Pressed) -> None:
        event.stop()
        if event.button.name is None:
            self.close()
        else:
            self._give(self._keys_of[event.button.name])

    def _give(self, answer: Answer) -> None:
        if self.is_active:
            self.close()
            answer.do()
