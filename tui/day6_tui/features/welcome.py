"""The pane shown while there are no windows: first the welcome choices, later commands that open a window."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import NamedTuple

from rich.segment import Segment
from rich.style import Style
from textual import events

from day6_core.lessons.scene import Scene, scenes
from day6_tui.appearance.colours import background_of
from day6_tui.appearance.look import Look
from day6_tui.panes.canvas import PixelCanvas
from day6_tui.panes.cells import cell_len, clip, fit, wrap
from day6_tui.panes.pane import Pane, PaneMessage
from day6_tui.textual_private.survival import PersonMessage
from day6_tui.windows.turtlesim.shapes import COATS, pixels

LOGO_SIZE = 20
"""Columns of the turtle of the welcome pane."""


class WelcomeChoice(NamedTuple):
    """An entry: the texts to show, and what choosing it does ('action.<id>' or 'type:<command>')."""

    text: str
    more: str
    does: str


def _choice(scene: Scene) -> WelcomeChoice:
    does = f"action.scene.{scene.name}" if scene.is_action else "guide"
    return WelcomeChoice(f"welcome.{scene.name}", f"welcome.{scene.name}.more", does)


WELCOME = (
    *(_choice(scene) for scene in scenes().values() if scene.is_action),
    WelcomeChoice("welcome.lessons", "welcome.lessons.more", "action.lessons"),
    *(_choice(scene) for scene in scenes().values() if not scene.is_action),
)
"""The choices of the start, by their text keys."""

GUIDE_COMMANDS = (
    "ros2 run turtlesim turtlesim_node",
    "ros2 run turtlesim turtle_teleop_key",
    "rqt_graph",
)
GUIDE_QUESTIONS = ("ros2 node list", "ros2 topic list -t", "ros2 topic echo /turtle1/cmd_vel")

_LOGO_ASCII = (
    r"    __   ____   ",
    r"   /  \_/    \  ",
    r"     /  /\/\  \__",
    r"    |  <    > |o )",
    r"     \  \/\/  /~~",
    r"   \__/~\____/  ",
)


class WelcomePane(Pane):
    """The welcome choices, or (`guide`) the commands worth trying. A command typed here goes to a terminal."""

    help_key = "welcome"

    class Did(PaneMessage, PersonMessage):
        """Base of this pane's messages."""

    class Chosen(Did):
        """An entry was chosen; `does` is what it does."""

        def __init__(self, pane: WelcomePane, does: str) -> None:
            super().__init__(pane)
            self.does = does

    class Closed(Did):
        """It is not wanted any more."""

    class Typed(Did):
        """A key that is no choice."""

        def __init__(self, pane: WelcomePane, key: events.Key) -> None:
            super().__init__(pane)
            self.key = key

    class Pasted(Did):
        """Text was pasted."""

        def __init__(self, pane: WelcomePane, text: str) -> None:
            super().__init__(pane)
            self.text = text

    def __init__(self, look: Look, last_lesson: Callable[[], str]) -> None:
        super().__init__(look, id="welcome")
        self._last_lesson = last_lesson
        """The title of the lesson of the last time, or ''."""
        self._told_lesson = ""
        self.guide = False
        self.chosen = 0
        self._leaving = False
        """Whether the user has begun to type a command for a terminal: the focus moves a moment later than quick fingers."""
        self._built: list[list[Segment]] = []
        self._rows: dict[int, int] = {}
        self._built_for: object = None

    # -- state ---------------------------------------------------------------------------------------------------------

    def show_guide(self) -> None:
        """Change from the choices of the start to the guide."""
        if not self.guide:
            self.guide = True
            self.help_key = "guide"
            self.chosen = 0
            self.touch()

    @property
    def choices(self) -> list[WelcomeChoice]:
        if not self.guide:
            return list(WELCOME)
        commands = [WelcomeChoice(command, "", f"type:{command}") for command in (*GUIDE_COMMANDS, *GUIDE_QUESTIONS)]
        scenes = [WelcomeChoice(choice.text, choice.more, choice.does) for choice in WELCOME[:-1]]
        return [*commands, *scenes]

    def choose(self, index: int) -> None:
        """Do what the entry with this index does."""
        choices = self.choices
        if 0 <= index < len(choices):
            self.chosen = index
            self.touch()
            self.post_message(self.Chosen(self, choices[index].does))

    # -- drawing -------------------------------------------------------------------------------------------------------

    @property
    def label(self) -> str:
        return self.look.texts("guide.title" if self.guide else "welcome.title")

    def close(self) -> None:
        self.post_message(self.Closed(self))

    def pull(self, now: float) -> bool:
        if self._last_lesson() != self._told_lesson:
            self._told_lesson = self._last_lesson()
            self.touch()
        return False

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        state = (
            width,
            self.inner_height,
            self.chosen,
            self.guide,
            self.look.texts.language,
            self.look.colours,
            self.has_focus,
            self._last_lesson(),
        )
        if state != self._built_for:
            self._built_for = state
            self._built = self._build_guide(width) if self.guide else self._build_welcome(width)
        if y in self._rows:
            index = self._rows[y]
            self.add_hit(y + 1, 1, 1 + width, lambda: self.choose(index))
        return self._built[y] if y < len(self._built) else []

    def _build_welcome(self, width: int) -> list[list[Segment]]:
        """The choices with as much around them as there is room for."""
        for logo, gaps, details, question in (
            (True, True, True, True),
            (False, True, True, True),
            (False, False, True, True),
            (False, False, False, True),
            (False, False, False, False),
        ):
            if logo and width < 30:
                continue
            lines = self._welcome(width, logo=logo, gaps=gaps, details=details, question=question)
            if len(lines) <= self.inner_height:
                break
        return self._centre_vertically(lines)

    def _welcome(self, width: int, *, logo: bool, gaps: bool, details: bool, question: bool) -> list[list[Segment]]:
        texts, colours = self.look.texts, self.look.colours
        lines: list[list[Segment]] = [*self._logo(width), []] if logo else []
        self._rows = {}
        if question:
            lines += [_centred(texts("welcome.heading"), width, colours.strong), []]
            lines += [_centred(texts("welcome.question"), width, colours.text), []]
        elif self.inner_height >= len(WELCOME) + 2:
            lines.append(_centred(texts("welcome.heading"), width, colours.strong))
        block = min(width - 2, 44)
        margin = Segment(" " * ((width - block) // 2), colours.text)
        for index, choice in enumerate(WELCOME):
            on = index == self.chosen
            style, more = (colours.choice, colours.choice) if on else (colours.strong, colours.muted)
            marker = self.look.glyphs.marker if on else " "
            self._rows[len(lines)] = index
            lines.append([margin, Segment(fit(f" {marker} {index + 1}  {self._entry(choice, details)}", block), style)])
            if details:
                self._rows[len(lines)] = index
                lines.append([margin, Segment(fit(f"      {self._more(choice)}", block), more)])
            if gaps and details and choice is not WELCOME[-1]:
                lines.append([])
        if details:
            truth = wrap(texts("welcome.truth"), min(width - 4, 60))
            lines += [[], *(_centred(line, width, colours.muted) for line in truth)]
        if details or self.inner_height > len(lines):
            if self.inner_height > len(lines) + 1:
                lines.append([])
            lines.append(_centred(clip(texts("welcome.keys"), width), width, colours.muted))
        return lines

    def _entry(self, choice: WelcomeChoice, details: bool) -> str:
        """A choice; where there is no line below it, with where one stopped."""
        last = self._last_lesson() if choice.does == "action.lessons" and not details else ""
        return self.look.texts("welcome.lessons.on", title=last) if last else self.look.texts(choice.text)

    def _more(self, choice: WelcomeChoice) -> str:
        """The line below a choice; of the lessons, where one stopped."""
        last = self._last_lesson() if choice.does == "action.lessons" else ""
        return self.look.texts("welcome.lessons.on", title=last) if last else self.look.texts(choice.more)

    def _logo(self, width: int) -> list[list[Segment]]:
        """A turtle, drawn as those of turtlesim are."""
        colours = self.look.colours
        if self.look.glyphs.canvas not in ("half", "braille"):
            return [_centred(line, width, colours.publisher) for line in _LOGO_ASCII]
        canvas = PixelCanvas(
            LOGO_SIZE, LOGO_SIZE // 2, "half", background_of(colours.text), colourless=colours.colourless
        )
        middle = LOGO_SIZE // 2
        sprites = {}
        for dx, dy, part in pixels(LOGO_SIZE - 2, 0):
            if (index := canvas.index(middle + dx, middle + dy)) is not None:
                sprites[index] = COATS[0][part]
        canvas.set_sprites(sprites)
        margin = Segment(" " * ((width - LOGO_SIZE) // 2), colours.text)
        return [[margin, *canvas.line(row)] for row in range(canvas.rows)]

    def _build_guide(self, width: int) -> list[list[Segment]]:
        texts, colours = self.look.texts, self.look.colours
        self._rows = {}
        entries = self.choices
        roomy = self.inner_height >= len(entries) + 9
        lines: list[list[Segment]] = []

        def heading(key: str) -> None:
            if roomy and lines:
                lines.append([])
            lines.append([Segment(" " + clip(texts(key), width - 1), colours.text)])

        for index, choice in enumerate(entries):
            if index == 0:
                heading("guide.heading")
            elif index == len(GUIDE_COMMANDS):
                heading("guide.ask")
            elif index == len(GUIDE_COMMANDS) + len(GUIDE_QUESTIONS):
                heading("guide.scene")
            on = index == self.chosen and self.has_focus
            marker = self.look.glyphs.marker if on else " "
            command = choice.does.startswith("type:")
            text = choice.text if command else texts(choice.text)
            style = colours.choice if on else colours.publisher if command else colours.strong
            self._rows[len(lines)] = index
            text = clip(f" {marker} {text} ", width, self.look.glyphs.ellipsis)
            lines.append([Segment("  " if roomy else "", colours.text), Segment(text, style)])
        if roomy:
            lines.append([])
        if len(lines) < self.inner_height:
            lines.append([Segment(" " + clip(texts("guide.try"), width - 1), colours.muted)])
        return self._centre_vertically(lines, top=1 if roomy else 0)

    def _centre_vertically(self, lines: list[list[Segment]], top: int | None = None) -> list[list[Segment]]:
        spare = self.inner_height - len(lines)
        if spare < 0:
            # Too low for everything: keep the chosen entry in sight.
            row = next((row for row, index in self._rows.items() if index == self.chosen), 0)
            first = max(0, min(row - self.inner_height // 2, -spare))
            self._rows = {row - first: index for row, index in self._rows.items() if row >= first}
            return lines[first:]
        above = spare // 2 if top is None else min(top, spare)
        self._rows = {row + above: index for row, index in self._rows.items()}
        return [[] for _ in range(above)] + lines

    # -- keys ----------------------------------------------------------------------------------------------------------

    def on_key(self, event: events.Key) -> None:
        count = len(self.choices)
        number = "123456789".find(event.character) if event.character and not self.guide else -1
        if self._leaving:
            self.post_message(self.Typed(self, event))
        elif event.key in ("down", "tab"):
            self.chosen = (self.chosen + 1) % count
        elif event.key in ("up", "shift+tab"):
            self.chosen = (self.chosen - 1) % count
        elif event.key in ("enter", "space"):
            self.choose(self.chosen)
        elif 0 <= number < count:
            self.choose(number)
        elif event.character and event.character.isprintable():
            self._leaving = True
            self.post_message(self.Typed(self, event))
        else:
            return
        event.stop()
        event.prevent_default()
        self.touch()

    def on_paste(self, event: events.Paste) -> None:
        event.stop()
        self._leaving = True
        self.post_message(self.Pasted(self, event.text))

    def on_blur(self, event: events.Blur) -> None:
        self._leaving = False


def _centred(text: str, width: int, style: Style) -> list[Segment]:
    left = max(0, (width - cell_len(text)) // 2)
    return [Segment(" " * left, style), Segment(text, style)]
