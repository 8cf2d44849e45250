"""Scenes: the steps a teacher would take, as data, and the player that types them where everybody can see it.

A step is a tuple: ('terminal', 'new'|'idle') chooses where to type, ('type', command) types it and presses Return (unless it is
empty), ('window', kind) waits until such a window is open, ('topic', name) until the topic is there, ('heard', name) until
`ros2 topic echo` listens to it, ('reading', '') until the program reads keys, ('pause', seconds) lets one look. A command that
fails ends the scene, as a teacher would stop to read what it says.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple, Protocol

Step = tuple[str, str]


class Scene(NamedTuple):
    """A name, and what is done."""

    name: str
    steps: tuple[Step, ...]

    @property
    def needs_robot(self) -> bool:
        """Whether a command names a robot's URDF file."""
        return any("{robot}" in value for _, value in self.steps)


SCENES: dict[str, Scene] = {
    "turtle": Scene(
        "turtle",
        (
            ("terminal", "idle"),
            ("type", "ros2 run turtlesim turtlesim_node"),
            ("window", "turtlesim"),
            ("pause", "0.4"),
            ("terminal", "new"),
            ("type", "ros2 topic echo /turtle1/cmd_vel"),
            ("pause", "0.6"),
            ("heard", "/turtle1/cmd_vel"),
            ("terminal", "new"),
            ("type", "ros2 run turtlesim turtle_teleop_key"),
            ("reading", ""),
        ),
    ),
    "car": Scene(
        "car",
        (
            ("terminal", "idle"),
            ("type", "{fetch}"),
            ("type", "ros2 run robot_state_publisher robot_state_publisher {robot}"),
            ("topic", "/robot_description"),
            ("pause", "0.6"),
            ("terminal", "new"),
            ("type", "ros2 run day6_bot car_view"),
            ("window", "car"),
            ("pause", "0.6"),
            ("terminal", "new"),
            ("type", "ros2 run day6_bot wheel_spinner"),
        ),
    ),
    "world": Scene(
        "world",
        (
            ("terminal", "idle"),
            ("type", "ros2 launch day6_world world.launch.py world:=walls"),
            ("window", "world"),
            ("pause", "0.8"),
            ("terminal", "new"),
            ("type", "ros2 run teleop_twist_keyboard teleop_twist_keyboard"),
            ("reading", ""),
        ),
    ),
    "empty": Scene("empty", ()),
}

KEYS_PER_SECOND = 40.0
"""Characters per second: slow enough to read along."""

LONGEST_WAIT = 6.0
"""Seconds a step waits for a window or program."""

STAYS = 0.3
"""Seconds for which a topic has to be there."""

FAILED_AFTER = 1.5
"""Seconds after a command from which a prompt means that it has ended: before, it may not have begun."""


class Stage(Protocol):
    """What a scene acts on."""

    def use_terminal(self, which: str) -> None:
        """Type into an idle terminal ('idle') or a new one ('new') from now on."""

    def send(self, text: str) -> None:
        """Type into that terminal."""

    def ready(self) -> bool:
        """Whether that terminal shows its prompt and waits for a command."""

    def has_window(self, kind: str) -> bool: ...

    def has_topic(self, name: str) -> bool: ...

    def is_heard(self, name: str) -> bool:
        """Whether a command of ROS (`ros2 topic echo`) listens to a topic."""

    def reading_keys(self) -> bool:
        """Whether the program in that terminal reads single keys."""


class Player:
    """Plays a scene in small pieces: call `advance` with the time until `done`."""

    def __init__(self, scene: Scene, stage: Stage, *, values: dict[str, str], visibly: bool = True) -> None:
        self.scene = scene
        self.done = False
        self._stage = stage
        self._values = values
        self._visibly = visibly
        self._play: Iterator[float] = self._perform()
        self._next = 0.0
        self._now = 0.0

    def advance(self, now: float) -> None:
        """Do what is due at the monotonic time `now`."""
        self._now = now
        while not self.done and now >= self._next:
            try:
                self._next = self._now + next(self._play)
            except StopIteration:
                self.done = True

    def hurry(self) -> None:
        """Type the rest at once (the user pressed a key)."""
        self._visibly = False
        self._next = 0.0

    def _perform(self) -> Iterator[float]:
        stage = self._stage
        for kind, value in self.scene.steps:
            if kind == "terminal":
                stage.use_terminal(value)
            elif kind == "type":
                yield from self._until(stage.ready)
                yield from self._type(value.format(**self._values))
            elif kind == "window":
                yield from self._until(partial(stage.has_window, value))
                if not stage.has_window(value):
                    return
            elif kind == "topic":
                yield from self._until(partial(stage.has_topic, value))
                yield STAYS  # a program that refuses its input may have published for a moment
                if not stage.has_topic(value):
                    return
            elif kind == "heard":  # an arrow key that waits for the teleop would come before it
                yield from self._until(partial(stage.is_heard, value))
            elif kind == "reading":
                yield from self._until(stage.reading_keys)
            elif kind == "pause" and self._visibly:
                yield float(value)

    def _type(self, command: str) -> Iterator[float]:
        if not command:
            return
        if self._visibly:
            for char in command:
                self._stage.send(char)
                yield 1.0 / KEYS_PER_SECOND
            yield 0.25
            self._stage.send("\r")
        else:
            self._stage.send(command + "\r")
        yield 0.0

    def _until(self, condition: Callable[[], bool]) -> Iterator[float]:
        """Wait for `condition`, with a time limit, and only until the program it depends on has ended."""
        began = self._now
        while not condition():
            waited = self._now - began
            if waited > LONGEST_WAIT or (
                waited > FAILED_AFTER and condition != self._stage.ready and self._stage.ready()
            ):
                return
            yield 0.03
