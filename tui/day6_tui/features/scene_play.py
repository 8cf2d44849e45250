"""Plays a scene on the desktop: where it types, and what happens to keys the user presses meanwhile."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.lessons.player import Steering
from day6_core.lessons.scene import below, scenes
from day6_core.virtual import surroundings
from day6_tui.actions import Handlers
from day6_tui.features import world_ticks
from day6_tui.parts import Feature, Parts
from day6_tui.terminals.pane import TerminalPane
from day6_tui.terminals.view import TerminalView

if TYPE_CHECKING:
    from day6_core.lessons.checks import Condition
    from day6_core.lessons.live import Live
    from day6_core.lessons.scene_player import ScenePlayer
    from day6_core.virtual.surroundings import Pace

TICK = 1 / 30
"""Seconds of the world between two looks at what a scene does next, in virtual time."""


class ScenePlay(Feature):
    """Plays one scene at a time in the terminals (it is the player's `scene_player.Place`)."""

    def __init__(self, parts: Parts, robot: str | None, follow: Callable[[], None], *, visibly: bool = True) -> None:
        super().__init__(parts)
        self._follow = follow
        """Gives what is new its place."""
        self._robot = robot
        self._held = parts.terminals.held
        self._visibly = visibly
        self._live: Live | None = None
        """What a scene waits for is seen here."""
        self.player: ScenePlayer | None = None
        """The player of the scene; None while no scene is played."""
        self.steering = Steering(changed=lambda: parts.look.wake())
        self.said = ""
        """The sentence that is shown."""
        self._held.steer = self._steer
        self.namespace: Callable[[], str] = lambda: ""
        """Where scenes begin: below the pupil's name in a room, where all share one graph."""

    def actions(self) -> Handlers:
        return {
            **{
                f"scene.{scene.name}": partial(self.start, scene.name) for scene in scenes().values() if scene.is_action
            },
            "scene.pause": self.steering.hold,
            "scene.step": self.steering.step,
            "scene.faster": partial(self.steering.change_speed, 1),
            "scene.slower": partial(self.steering.change_speed, -1),
        }

    def start(self, name: str) -> None:
        """Type the commands of a scene."""
        from day6_core.lessons.actions import filled

        actions = list(scenes()[name].actions)
        if "@robot@" in str(actions):
            actions = filled(actions, self._machine.robot_words(self._robot))
        namespace = self.namespace()
        self.play(list(below(actions, namespace)) if namespace else actions)

    def play(self, actions: Sequence[Mapping[str, Any]]) -> None:
        """Perform the actions of a scene, any list of them."""
        from day6_core.lessons.scene_player import ScenePlayer

        self._desktop.welcome.show_guide()
        if (pane := self._terminals.current) is not None:
            self._desktop.focus_pane(pane)
        if actions:
            self.steering.begin(seen=self._visibly and not self._look.reduced_motion)
            is_first = self.player is None
            self.player = ScenePlayer(actions, self, self.steering)
            self._held.begin()
            if surroundings.pace is not None and is_first:
                world_ticks.each(TICK, partial(self._advance_in_world, surroundings.pace))
        self._look.wake()

    def _advance_in_world(self, pace: Pace) -> bool:
        self._follow()
        self.advance(pace.now / 1e9)
        self._look.wake()
        return self.player is not None

    # -- steering ------------------------------------------------------------------------------------------------------

    def stop(self) -> None:
        """End the scene where it is."""
        self._held.end()
        self._look.wake()

    def _steer(self, key: str) -> bool:
        """Do what a key means that was pressed in the scene's terminal; False if it is none of these.

        While the scene is paused one may type, so there only keys that write nothing steer: those of a presenter's clicker.
        """
        if key == "pagedown":
            self.steering.step()
        elif key == "pageup":
            self.steering.hold()
        elif self.steering.held:
            return False
        elif key == "space":
            self.steering.hold()
        elif key in ("plus", "equals_sign", "minus"):
            self.steering.change_speed(-1 if key == "minus" else 1)
        else:
            return False
        return True

    def advance(self, now: float) -> bool:
        """Type what is due at the monotonic time `now`; True while the scene goes on."""
        if self.player is None:
            return False
        if not self._held.holding:  # Esc
            self.player, self.said = None, ""
            return False
        if self._machine.desk is None:
            return True  # a quick key: the desk comes right after the first frame
        if self._held.keys:
            self.player.hurry()
        self.player.advance(now)
        self._held.paused = self.steering.held
        if not self.player.done:
            return not self.steering.held
        view, keys = self._held.view, self._held.keys
        self._end()
        if (pane := self._pane_of(view)) is not None:
            for event in keys:
                pane.type_key(event)
        return False

    def _end(self) -> None:
        self.player, self.said = None, ""
        self._held.end()

    # -- what a scene acts on (scene_player.Place) ---------------------------------------------------------------------

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

    def holds(self, condition: Condition) -> bool:
        from day6_core.lessons.live import Live

        if self._live is None and self._machine.desk is not None:
            self._live = Live(self._machine.desk, None, Path())
        return self._live is not None and condition.judge(self._live).ok

    def is_heard(self, name: str) -> bool:
        return self._machine.is_heard(name)

    def reading_keys(self) -> bool:
        return self._view is not None and self._view.reading_keys

    def say(self, text: str) -> None:
        self.said = text
