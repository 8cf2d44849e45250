"""What a pupil's desktop finds to tell of itself: where its lesson is, what has failed, which nodes run, the screen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.classroom.note import LessonPlace, PupilScreen, Trouble
from day6_core.session.harmless import one_line
from day6_tui.terminals.pane import TerminalPane
from day6_tui.textual_private.access import lines_of

if TYPE_CHECKING:
    from textual.strip import Strip

    from day6_core.shell.runs import Run
    from day6_tui.app import Day6App

LAST_LINES = 2
"""Of a program that still runs, in which a message is looked for: what stands further up is over."""


class Observed:
    """Looks at the desktop when there is something to tell; a look that would find the same is not taken."""

    def __init__(self, app: Day6App) -> None:
        self._app = app
        self.has_drawn = True
        """Whether the screen has changed since the last picture; the application writes it."""
        self._picture: PupilScreen | None = None
        self._looked: tuple[object, Trouble | None] = (None, None)
        """What was run last when a card was looked for, and how much it had printed; and the card."""

    def look_again(self) -> None:
        """A picture is wanted: one has to be taken if there is none."""
        self.has_drawn = self.has_drawn or self._picture is None

    def nodes(self) -> tuple[str, ...]:
        """Return the full names of the nodes that are not hidden."""
        desk = self._app.machine.desk
        nodes = desk.graph.nodes if desk is not None else ()
        return tuple(sorted({node.full_name for node in nodes if not node.name.startswith("_")}))

    def lesson(self) -> LessonPlace | None:
        """Return where the pupil is in the lesson that is open."""
        pane = self._app.lessons.pane
        state = pane.course.state if pane is not None else None
        if state is None or state.lesson is None:
            return None
        lesson = state.lesson
        return LessonPlace(
            lesson.name, dict(lesson.title), state.index + 1, len(lesson.steps), state.solved, state.hints
        )

    def trouble(self) -> Trouble | None:
        """Return the card of what was run last in any terminal, if it has failed, or of what it waits for."""
        from day6_core.shell.builtins.why import is_own

        runs: list[Run] = []
        for pane in self._app.desktop.terminals():
            if pane.has_terminal:
                runs += [run for run in pane.view.terminal.runs.all if not is_own(run.source)][-1:]
        last = max(runs, key=lambda run: run.began_ns, default=None)
        if last is None or last.status == 0:
            return None
        looked = (last, last.status, last.written)
        if self._looked[0] != looked:
            self._looked = (looked, _card_of(last.output, LAST_LINES if last.status is None else None))
        return self._looked[1]

    def screen(self) -> PupilScreen | None:
        """Return the screen as it is now; the last picture where nothing was drawn since."""
        app = self._app
        if app.detachment.away or not app.screen.size:
            return self._picture
        if self.has_drawn or self._picture is None:
            self.has_drawn = False
            ansi = "\n".join(strip.render(app.console) for strip in strips_of(app))
            self._picture = PupilScreen(app.size.width, app.size.height, ansi, _work(app))
        return self._picture


def _work(app: Day6App) -> tuple[int, ...] | None:
    """See `PupilScreen.work`; in a terminal, the line of the cursor counts."""
    pane = app.desktop.focused_pane
    place = pane.region.intersection(app.screen.region) if pane is not None and pane.region else None
    if pane is None or not place:
        return None
    cursor = pane.view.cursor if isinstance(pane, TerminalPane) and pane.has_terminal else None
    line = place.bottom - 1 if cursor is None else min(pane.region.y + 1 + cursor[1], place.bottom - 1)
    return (*place, line)


def strips_of(app: Day6App) -> list[Strip]:
    """The lines of the screen; pictures of real pixels as half blocks."""
    strips = lines_of(app)
    pictures = app.look.pixels
    return strips if pictures is None else pictures.drawn_over(strips)


def _card_of(output: str, lines: int | None) -> Trouble | None:
    """The card of an output, of its last lines only where it may go on."""
    from day6_core.advice.matching import cards_in
    from day6_core.advice.wording import filled_in
    from day6_core.language import LANGUAGES

    if lines is not None:
        output = "\n".join(output.rstrip().splitlines()[-lines:])
    match = next(cards_in(output), None)
    if match is None:
        return None
    titles = {language: filled_in(match.card.words[language].first, match.values) for language in LANGUAGES}
    return Trouble(titles, one_line(match.line))
