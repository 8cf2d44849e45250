"""The world of turtlesim: its turtles by name, the trail, the background (turtlesim/turtle_frame.cpp).

The node's thread changes it; a window reads `scene` and `trail` from another thread at any time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from day6_core.ros import differences
from day6_core.ros.programs.turtlesim.model.trail import Trail
from day6_core.ros.programs.turtlesim.model.turtle import HEIGHT, WIDTH, Turtle, TurtleStep

_PICTURES = (
    *("ardent", "bouncy", "crystal", "dashing", "eloquent", "foxy"),
    *("galactic", "humble", "iron", "jazzy", "kilted", "lyrical"),
)


def kinds() -> tuple[str, ...]:
    """Return the pictures a turtle can wear: one for each distribution up to this one, and Rolling's."""
    newest = _PICTURES.index(differences.value("turtlesim.newest_picture"))
    return (*_PICTURES[: newest + 1], "rolling")


DEFAULT_BACKGROUND = (0x45, 0x56, 0xFF)


class TurtleView(NamedTuple):
    """A turtle as a window sees it: metres from the bottom left corner, radians, m/s, rad/s."""

    name: str
    kind: str
    x: float
    y: float
    theta: float
    linear_velocity: float
    angular_velocity: float


class TurtleTopics(NamedTuple):
    """The full names of a turtle's topics, and the nodes that publish its velocities."""

    pose: str
    cmd_vel: str
    senders: tuple[str, ...]


class TurtleScene(NamedTuple):
    """One whole picture but for the trail: the turtles in drawing order, and red, green, blue of the background."""

    turtles: tuple[TurtleView, ...]
    background: tuple[int, int, int]


class Simulation:
    """A world with no turtle in it yet.

    `choose(n)` picks a picture, a number from 0 to n - 1. `scene` is replaced by a new one whenever it changes, so a
    window that finds the same object again (and `trail.generation`, `trail.drawn` unchanged) has nothing to draw.
    """

    def __init__(self, choose: Callable[[int], int], *, node_name: str = "/turtlesim") -> None:
        self.node_name = node_name
        self.trail = Trail()
        self.turtles: dict[str, Turtle] = {}  # kept in the order of names: std::map's, in which turtles move and draw
        self.background = DEFAULT_BACKGROUND
        self.scene = TurtleScene((), DEFAULT_BACKGROUND)
        self.topics: dict[str, TurtleTopics] = {}
        """By the turtles' names; replaced by a new one when it changes."""
        self.rests = False
        """Whether ticks change nothing until somebody does something to a turtle."""
        self._choose = choose
        self._counter = 0
        self._started = False

    def free_name(self, name: str) -> str | None:
        """Return the name for a turtle wanted as `name`, None if it is taken; '' asks for the next turtleN."""
        if name:
            return None if name in self.turtles else name
        while True:
            self._counter += 1
            name = f"turtle{self._counter}"
            if name not in self.turtles:
                return name

    def create(self, name: str, x: float, y: float, theta: float, now: int) -> Turtle:
        """Return a new turtle, not yet in the world, in a picked picture, at the pose (metres, radians)."""
        pictures = kinds()
        return Turtle(name, x, y, theta, kind=pictures[self._choose(len(pictures))], now=now)

    def add(self, turtle: Turtle) -> None:
        """Put the turtle, whose name must be free, into the world."""
        self.turtles = dict(sorted([*self.turtles.items(), (turtle.name, turtle)]))
        self._refresh()

    def remove(self, name: str) -> bool:
        """Take the turtle away, its trail stays; False if there is none of that name."""
        if self.turtles.pop(name, None) is None:
            return False
        self._refresh()
        return True

    def clear(self) -> None:
        """Wipe the trails."""
        self.trail.clear()

    def remove_all(self) -> None:
        """Take every turtle away and count names from turtle1 again (the first half of reset)."""
        self.turtles = {}
        self._counter = 0
        self._refresh()

    def set_background(self, r: int, g: int, b: int) -> None:
        """Change the background colour (0..255 each)."""
        self.background = (r, g, b)
        self._refresh()

    def glides(self, ticks: int) -> bool:
        """Whether so many ticks only move turtles: none hits a wall, or turns to a goal whose client wants news."""
        return all(turtle.glides(ticks) for turtle in self.turtles.values())

    def tick(self, now: int) -> list[tuple[Turtle, TurtleStep]]:
        """Let every turtle live through one tick, in the order of their names. The very first tick does nothing."""
        if not self._started:
            self._started = True
            return []
        steps = [(turtle, turtle.step(now, self.trail)) for turtle in self.turtles.values()]
        changed = any(step.changed for _, step in steps)
        if changed:
            self._refresh()
        self.rests = not changed and all(turtle.stands for turtle in self.turtles.values())
        return steps

    def _refresh(self) -> None:
        self.scene = TurtleScene(
            tuple(TurtleView(turtle.name, turtle.kind, *turtle.pose) for turtle in self.turtles.values()),
            self.background,
        )


CENTRE = (WIDTH / 2.0, HEIGHT / 2.0)
"""Where turtle1 begins, in metres."""
