"""Scenes: the steps a teacher would take, as data, and the player that types them where everybody can see it.

A step is a tuple: ('terminal', 'new'|'idle') chooses where to type, ('type', command) types it and presses Return (unless it is
empty), ('window', kind) waits until such a window is open, ('topic', name) until the topic is there, ('heard', name) until
`ros2 topic echo` listens to it, ('reading', '') until the program reads keys, ('say', text) shows a sentence for as long as it
takes to read it, ('pause', seconds) lets one look. A command that fails ends the scene, as a teacher would stop to read what it
says.

Whoever looks on can pause a scene anywhere, go on by one command at a time, and choose how fast it is typed. The time for which a
scene was paused counts for none of its waits.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple, Protocol

from day6_core.width import text_width

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


def below(scene: Scene, namespace: str) -> Scene:
    """Return a scene in a namespace, for who shares a graph with others. What is launched keeps its names."""
    steps = []
    for what, value in scene.steps:
        if what == "type" and value.startswith("ros2 run "):
            value += f" --ros-args -r __ns:=/{namespace}"
        elif what == "type":
            value = value.replace("ros2 topic echo /", f"ros2 topic echo /{namespace}/")
        elif what in ("topic", "heard"):
            value = f"/{namespace}{value}"
        steps.append((what, value))
    return scene._replace(steps=tuple(steps))


KEYS_PER_SECOND = 40.0
"""Characters per second: slow enough to read along."""

WORDS_SECONDS = 1.5
"""What a sentence gets at least, before anything is typed."""

READ_PER_SECOND = 15.0
"""Cells of a sentence that are read in a second."""

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

    def say(self, text: str) -> None:
        """Show a sentence, '' for none."""


class Player:
    """Plays a scene in small pieces: call `advance` with the time until `done`."""

    def __init__(self, scene: Scene, stage: Stage, *, values: dict[str, str], visibly: bool = True) -> None:
        self.scene = scene
        self.done = False
        self._stage = stage
        self._values = values
        self._visibly = visibly
        self.paused = False
        self.speed = 1.0
        """One of `speeds.SPEEDS`: how fast is typed, and how long one looks."""
        self._stops_at_command = False
        """Whether it pauses before the next command."""
        self._play: Iterator[float] = self._perform()
        self._next = 0.0
        self._now = 0.0
        self._stood = 0.0
        """Seconds that it was paused so far, and since when it is."""
        self._stands_since: float | None = None

    def advance(self, now: float) -> None:
        """Do what is due at the monotonic time `now`."""
        if self.paused:
            self._stands_since = now if self._stands_since is None else self._stands_since
            return
        if self._stands_since is not None:
            self._stood += now - self._stands_since
            self._stands_since = None
        self._now = now = now - self._stood
        while not self.paused and not self.done and now >= self._next:
            try:
                self._next = self._now + next(self._play)
            except StopIteration:
                self.done = True

    def hurry(self) -> None:
        """Type the rest at once (the user pressed a key)."""
        self._visibly = False
        self._stops_at_command = False
        self._next = 0.0

    def step(self) -> None:
        """Go on up to the next command, and pause before it."""
        self.paused = False
        self._stops_at_command = True

    def _perform(self) -> Iterator[float]:
        stage = self._stage
        for kind, value in self.scene.steps:
            if kind == "terminal":
                stage.use_terminal(value)
            elif kind == "type":
                yield from self._until(stage.ready)
                yield from self._stop_before_command()
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
            elif kind == "say":
                stage.say(value)
                if self._visibly:
                    yield max(WORDS_SECONDS, text_width(value) / READ_PER_SECOND) / self.speed
            elif kind == "pause" and self._visibly:
                yield float(value) / self.speed

    def _stop_before_command(self) -> Iterator[float]:
        """Pause here, if the step was to end here; the next one is over at the next command."""
        if self._stops_at_command:
            self._stops_at_command, self.paused = False, True
            yield 0.0

    def _type(self, command: str) -> Iterator[float]:
        if not command:
            return
        if self._visibly:
            for char in command:
                self._stage.send(char)
                yield 1.0 / KEYS_PER_SECOND / self.speed
            yield 0.25 / self.speed
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
