"""The facts that the rules judge: about the graph, the robot, the terminals, the files and the programs' insides. Plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from day6_core.facts.graph import GraphFacts
from day6_core.facts.workspaces import Package, Workspace
from day6_core.link.state import LinkState
from day6_core.ros.programs.day6_inspector.files import Files
from day6_core.ros.programs.day6_inspector.hearing import Heard
from day6_core.ros.programs.day6_inspector.process_reports import ReportedProcess
from day6_core.ros.programs.day6_inspector.transforms import Transform
from day6_core.session.overview import TerminalView


@dataclass(frozen=True)
class RVizView:
    """One RViz window: its Fixed Frame and the frames it knows, its enabled displays, and what their statuses say in red."""

    fixed_frame: str
    frames: tuple[str, ...]
    displays: tuple[str, ...]
    """Types of the enabled ones."""
    described: bool
    """Whether a RobotModel has read a description."""
    description_topic: str
    """Of the first RobotModel."""
    untransformed: tuple[str, ...] = ()
    """Frames without a transform to the Fixed Frame."""


@dataclass(frozen=True)
class RobotFacts:
    """What /robot_description says, as far as it concerns beginners' mistakes."""

    links: frozenset[str] = frozenset()
    mistakes: tuple[tuple[str, tuple[tuple[str, str], ...]], ...] = ()
    """Mistakes that parsers accept: `wheel_tumbles` …, each with the parameters of its text."""
    problem: str = ""
    """Why it cannot be read."""
    moved: tuple[tuple[str, str], ...] = ()
    """Joints that can move, each with the link that it moves."""
    limits: tuple[tuple[str, tuple[float, float]], ...] = ()
    """Joints with limits: the lower, the upper (radians or metres)."""


@dataclass(frozen=True)
class Facts(GraphFacts):
    """The facts about a graph and about what is around it."""

    missed: tuple[tuple[str, str, float], ...] = ()
    """Publishers that nobody who listens has heard: topic, node, the seconds it lived or 0 if it is still there."""
    rates: Mapping[str, float] = field(default_factory=dict)
    """Messages a second of topics that are subscribed to."""
    joint_states: str = "/joint_states"
    heard_joints: tuple[str, ...] = ()
    """Names in the newest joint states."""
    unequal_joints: tuple[int, int] | None = None
    """Where the newest joint states have not as many positions as names: the names, the positions."""
    timeless_joints: bool = False
    """Whether the newest joint states have no stamp."""
    joints: frozenset[str] | None = None
    """Names of the movable joints of the robot description; None while there is none."""
    robot: RobotFacts | None = None
    """The rest of it."""
    frames: frozenset[str] = frozenset()
    """Frames that transforms are sent of."""
    transforms: tuple[Transform, ...] = ()
    """The transforms that are sent now."""
    heard: tuple[Heard, ...] = ()
    """What publishers sent lately, as far as it was looked at."""
    unread: tuple[str, ...] = ()
    """Topics whose messages cannot be read here."""
    passed_over: int = 0
    """Topics that were not listened to, because there are so many."""
    rival_descriptions: tuple[str, ...] = ()
    """Nodes that send different robot descriptions."""
    clock: float | None = None
    """Seconds that /clock says, None without one."""
    link: LinkState = field(default_factory=LinkState)
    speed: float = 1.0
    """World seconds per real second that the user chose."""
    pace: float = 1.0
    """World seconds per real second as they were lately: less than `speed` where this computer was too slow."""
    rviz: tuple[RVizView, ...] = ()
    world: tuple[tuple[str, tuple[tuple[str, object], ...]], ...] = ()
    """What the worlds' windows complain about: key and parameters of their remarks."""
    terminals: tuple[TerminalView, ...] | None = None
    """None where there is nobody to ask about terminals."""
    now_ns: int = 0
    """Epoch nanoseconds, by the clock of the terminals' lines."""
    files: Files | None = None
    """None before they were looked at."""
    processes: tuple[ReportedProcess, ...] = ()
    """The reports of Python programs that run as processes."""
    windows: int = 0
    """RViz windows and worlds that were looked at."""
    unreported: tuple[str, ...] = ()
    """Nodes of other processes into which nobody can look."""
    silent_processes: tuple[str, ...] = ()
    """Nodes of programs on this machine that send no reports."""

    def package(self, name: str) -> tuple[Workspace, Package] | None:
        """Return a package of a workspace with this; None if there is none, or nobody has looked."""
        return self.files.package(name) if self.files is not None else None
