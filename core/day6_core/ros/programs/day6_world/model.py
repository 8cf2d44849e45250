"""The model of the world's window: a snapshot that the program swaps, a trail that only grows, and the window's requests."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from day6_core.ros.programs.day6_world._admission import AdmissionStatus
from day6_core.ros.programs.day6_world.scenery import Scenery
from day6_urdf.kinematics import Transform, link_transforms
from day6_urdf.model import Robot

LONGEST_TRAIL = 4000
TRAIL_STEP = 0.02
"""Metres between two points of the trail."""

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)


@dataclass(frozen=True, slots=True)
class Scan:
    """A lidar's rays: where from (x, y), the angle of the first one in the world, the angle between two, their lengths."""

    x: float
    y: float
    first: float
    step: float
    ranges: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class WorldSnapshot:
    """One moment. `pose` is x, y, yaw of the root link, `angles` are those of the joints that move."""

    version: int = 0
    seconds: float = 0.0
    scenery: Scenery | None = None
    robot: Robot | None = None
    pose: tuple[float, float, float] = (0.0, 0.0, 0.0)
    velocity: tuple[float, float] = (0.0, 0.0)
    angles: Mapping[str, float] = field(default_factory=dict)
    bumped: bool = False
    line: tuple[float, ...] = ()
    scan: Scan | None = None
    status: tuple[AdmissionStatus, ...] = ()
    paused: bool = False
    speed: float = 1.0
    """What was asked for: steps for every period of the machine's own clock, whose speed is another matter."""
    real_time_factor: float | None = None
    """What comes of both: simulated seconds per real second, measured."""

    def transforms(self) -> dict[str, Transform]:
        """Return the poses of the links in the root link's frame; computed on demand, not at every step."""
        return link_transforms(self.robot, self.angles) if self.robot is not None else {}


class Trail:
    """The robot's path. Points are only added until `generation` changes: then it was thinned or cleared."""

    def __init__(self) -> None:
        self.points: list[tuple[float, float]] = []
        self.generation = 0

    def add(self, x: float, y: float) -> None:
        points = self.points
        if points and (x - points[-1][0]) ** 2 + (y - points[-1][1]) ** 2 < TRAIL_STEP**2:
            return
        if len(points) >= LONGEST_TRAIL:
            # The older half keeps every second point, so that it stays whole and stays bounded.
            half = LONGEST_TRAIL // 2
            self.points = points = points[:half:2] + points[half:]
            self.generation += 1
        points.append((x, y))

    def clear(self) -> None:
        self.points = []
        self.generation += 1


class WorldModel:
    """The model of the world's window. The window reads `snapshot()` and `trail`, and calls `request`."""

    def __init__(self) -> None:
        self.trail = Trail()
        self._snapshot = WorldSnapshot()
        self._requests: list[str] = []
        self.on_request: Callable[[], object] | None = None
        self.is_held: Callable[[], bool] = lambda: False
        """Whether the machine's own clock is paused, and with it this world; it then shows nothing new."""
        self.wants_rays = False
        """Set by the window while it draws the lidar: then there is a scan even if nobody subscribes."""

    def snapshot(self) -> WorldSnapshot:
        """Return the newest moment (any thread)."""
        return self._snapshot

    @property
    def version(self) -> int:
        return self._snapshot.version

    def request(self, what: str) -> None:
        """Ask for 'pause', 'step', 'faster', 'slower', 'reset' or 'clear' (any thread)."""
        self._requests.append(what)
        if self.on_request is not None:
            self.on_request()

    def take_requests(self) -> list[str]:
        requests, self._requests = self._requests, []
        return requests

    def show(self, snapshot: WorldSnapshot) -> None:
        self._snapshot = snapshot
