"""Plays a scene on the desktop: where it types, and what happens to keys the user presses meanwhile."""

from __future__ import annotations

from day6_tui.tui.actions import Handlers
from day6_tui.tui.desktop import Desktop
from day6_tui.tui.look import Look
from day6_tui.tui.machine import Machine
from day6_tui.tui.scenes import SCENES, Player
from day6_tui.tui.terminal_pane import TerminalPane
from day6_tui.tui.terminal_view import TerminalView
from day6_tui.tui.terminals import Terminals


class ScenePlay:
    """Plays one scene at a time in the terminals (it is the player's `scenes.Stage`)."""

    def __init__(
        self,
        robot: str | None,
        machine: Machine,
        desktop: Desktop,
        terminals: Terminals,
        look: Look,
        *,
        visibly: bool = True,
    ) -> None:
        self._robot = robot
        self._machine = machine
        self._desktop = desktop
        self._terminals = terminals
        self._held = terminals.held
        self._look = look
        self._visibly = visibly
        self.player: Player | None = None
        """The player of the scene; None while no scene is played."""

    def actions(self) -> Handlers:
        return {
            "scene.turtle": lambda: self.start("turtle"),
            "scene.car": lambda: self.start("car"),
            "scene.world": lambda: self.start("world"),
        }

    def start(self, name: str) -> None:
        """Type the commands of a scene."""
        scene = SCENES[name]
        self._desktop.welcome.show_guide()
        if (pane := self._terminals.current) is not None:
            self._desktop.focus_pane(pane)
        if scene.steps:
            visibly = self._visibly and not self._look.reduced_motion
            values = self._machine.robot_words(self._robot) if scene.needs_robot else {}
            self.player = Player(scene, self, values=values, visibly=visibly)
            self._held.begin()
        self._look.wake()

    def advance(self, now: float) -> bool:
        """Type what is due at the monotonic time `now`; True while the scene goes on."""
        if self.player is None:
            return False
        if not self._held.holding:  # Esc
            self.player = None
            return False
        if self._machine.desk is None:
            return True  # a quick key: the desk comes right after the first frame
        if self._held.keys:
            self.player.hurry()
        self.player.advance(now)
        if not self.player.done:
            return True
        view, keys = self._held.view, self._held.keys
        self._end()
        if (pane := self._pane_of(view)) is not None:
            for event in keys:
                pane.type_key(event)
        return False

    def _end(self) -> None:
        self.player = None
        self._held.end()

    # -- what a scene acts on (scenes.Stage) ---------------------------------------------------------------------------

    def _pane_of(self, view: TerminalView | None) -> TerminalPane | None:
        return next((pane for pane in self._terminals.panes if pane.has_terminal and pane.view is view), None)

    @property
    def _view(self) -> TerminalView | None:
        """The terminal it types into, if that is still there."""
        return self._held.view if self._pane_of(self._held.view) is not None else None

    def use_terminal(self, which: str) -> None:
        desktop, held = self._desktop, self._held
        before = self._pane_of(held.view)
        keyboard = desktop.focused_pane
        pane = self._terminals.use_idle() if which == "idle" else self._terminals.open()
        held.view = pane.view if pane is not None else None
        if pane is not None and (held.view is None or keyboard is before or before is None):
            desktop.focus_pane(pane)  # else the user went to another one: the scene goes on beside it

    def send(self, text: str) -> None:
        if self._view is not None:
            self._view.terminal.send(text)

    def ready(self) -> bool:
        return self._view is not None and self._view.at_prompt

    def has_window(self, kind: str) -> bool:
        return any(window.kind == kind for window in self._machine.windows())

    def has_topic(self, name: str) -> bool:
        return self._machine.has_topic(name)

    def is_heard(self, name: str) -> bool:
        return self._machine.is_heard(name)

    def reading_keys(self) -> bool:
        return self._view is not None and self._view.reading_keys
