"""Opens the card of a message over the desktop: of what a terminal printed, of a line that was clicked, of a status of RViz."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.language import said
from day6_tui.bars.notices import NOTICE_SECONDS
from day6_tui.panes.pane import Pane
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.pane import TerminalPane

if TYPE_CHECKING:
    from day6_core.advice.matching import Match
    from day6_core.shell.terminal import Terminal

LONGEST = 8 * 1024
"""Characters of a selection in which a card is looked for."""


class Explaining(Feature):
    """Finds the card, lets it look around, shows it."""

    def __init__(self, parts: Parts) -> None:
        super().__init__(parts)

    def open_for(self, pane: Pane) -> bool:
        """Open the card of what is chosen in a pane, or was printed last there; False if that has none, or none in an exam."""
        if isinstance(pane, TerminalPane):
            return pane.has_terminal and self._open_for_terminal(pane)
        return bool(text := pane.unclear) and self._open_for_text(text, pane)

    def open_for_line(self, pane: TerminalPane, line: str) -> bool:
        """Open the card of one line of a terminal; False as above."""
        from day6_core.advice.matching import card_for
        from day6_core.shell.builtins.why import explained_lines

        if not pane.has_terminal:
            return False
        runs = pane.view.terminal.runs
        known = ((found, run) for found, run in explained_lines(runs) if found.line.strip() == line.strip())
        match, run = next(known, (card_for(line.strip()), None))
        if match is None:
            return False
        return self._show(match, pane, run.output if run is not None else line, run.source if run is not None else "")

    def _open_for_terminal(self, pane: TerminalPane) -> bool:
        from day6_core.advice.matching import cards_in, unfinished
        from day6_core.shell.builtins.why import is_own

        if selected := pane.view.selected_text()[-LONGEST:].strip():
            return self._open_for_text(selected, pane)
        waiting = pane.view.terminal.unfinished
        if waiting and (open_card := unfinished(waiting)) is not None:
            self._show(open_card, pane, "", "")
            return True
        runs = [run for run in pane.view.terminal.runs.all if not is_own(run.source)]
        match = next(cards_in(runs[-1].output), None) if runs else None
        if match is None:
            return False
        return self._show(match, pane, runs[-1].output, runs[-1].source)

    def _open_for_text(self, text: str, pane: Pane) -> bool:
        from day6_core.advice.matching import cards_in

        match = next(cards_in(text), None)
        if match is None:
            return False
        return self._show(match, pane, text, "")

    def _show(self, match: Match, pane: Pane, output: str, command: str) -> bool:
        from day6_core.advice.explain import explain, scene_of
        from day6_core.advice.rules import Surroundings
        from day6_core.advice.texts import TEXTS
        from day6_core.facts.graph import facts_of, nodes_by_domain
        from day6_core.graph.domain import DomainError
        from day6_core.shell.commands import command_names
        from day6_core.shell.desk import domain_of
        from day6_core.shell.language.hints import letters_awaited
        from day6_tui.overlays.card import CardModal

        desk = self._machine.desk
        if desk is None:
            return False
        if desk.searching() == "exam":
            self._notices.show(said(TEXTS["card.exam"], self._look.texts.language), NOTICE_SECONDS)
            return False
        terminal = self._terminal_of(pane)
        variables = terminal.shell.environment if terminal is not None else desk.environment()
        folder = terminal.shell.cwd if terminal is not None else desk.home
        try:
            graph = facts_of(desk.graph_of(domain_of(variables)), nodes_by_domain(desk.graphs.values()))
        except DomainError:
            graph = None
        around = Surroundings(variables, folder, launch=command.startswith("ros2 launch"))
        scene = scene_of(
            match,
            around,
            output=output,
            command=command,
            graph=graph,
            commands=command_names(),
            letters=letters_awaited(desk),
        )
        shown = explain(match, scene, self._look.texts.language)
        self._desktop.open_overlay(CardModal(self._look, shown, lambda line: self._type(line, pane)), about=pane)
        return True

    def _terminal_of(self, pane: Pane) -> Terminal | None:
        """Its own, or that which was used last."""
        chosen = pane if isinstance(pane, TerminalPane) else self._terminals.current
        return chosen.view.terminal if chosen is not None and chosen.has_terminal else None

    def _type(self, line: str, pane: Pane) -> None:
        """Type a command where the card was opened; in another terminal if a program runs there. Return is the pupil's."""
        target = pane if isinstance(pane, TerminalPane) and pane.has_terminal and pane.view.at_prompt else None
        if target is None and (target := self._terminals.use_idle()) is None:
            return
        terminal = target.view.terminal
        terminal.send(("" if terminal.idle else "\x05\x15") + line)
        self._desktop.focus_pane(target)
        self._look.wake()
