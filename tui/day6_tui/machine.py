"""The desktop's connection to the simulated machine: starts and ends it, wakes the frames when it changes, counts nodes."""

from __future__ import annotations

import math
import shlex
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.virtual import surroundings
from day6_tui.options import Options

if TYPE_CHECKING:
    from day6_core.link.state import Door
    from day6_core.session.display import Window
    from day6_core.session.session import Main
    from day6_core.shell.desk import Desk
    from day6_core.shell.terminal import Terminal


class Machine:
    """Holds the desk (None before it has started) and what the desktop's bars show of it."""

    def __init__(self, desk: Desk | None, *, wake: Callable[[], None]) -> None:
        self.desk: Desk | None = None
        self._given = desk
        self._wake = wake
        self._version = -1
        self._counts = (0, 0)
        self._changes = 0
        self._counted = -1
        """After how many changes of the graph `_counts` was counted; they come on other threads, also while one counts."""
        self._forget: Callable[[], None] | None = None

    def open(self, options: Options) -> None:
        """Start it. Raises OSError if the home folder cannot be used."""
        desk = self._given
        if desk is None:
            from day6_core.shell.desk import Desk

            desk = Desk(
                options.home,
                listen=options.listen,
                connect=options.connect,
                secret=options.secret,
                part=options.part,
            )
        desk.scheduler.on_activity = self._wake
        self._forget = desk.graph.add_listener(self._graph_changed)
        self.desk = desk
        if self._given is None:
            desk.start(link=False)

    def open_link(self) -> None:
        """Meet the other processes of this user."""
        if self._given is None and self.desk is not None:
            self.desk.open_link()

    def robot_words(self, given: str | None) -> dict[str, str]:
        """What a scene types for `@robot@`: a launch file's argument for the URDF file `given`, nothing for the shipped one."""
        return {"robot": f" robot:={shlex.quote(str(Path(given).expanduser().resolve()))}" if given else ""}

    def own_file(self, name: str) -> Path | None:
        """The file with this name in which the desktop keeps something in the home folder; None before there is one."""
        return self.desk.home / ".config" / "day6-tui" / name if self.desk is not None else None

    def hurry(self) -> None:
        """Make `close` stop waiting for programs. Any thread; before `close` or while it runs."""
        if self.desk is not None and self._given is None:
            self.desk.hurry()

    def close(self) -> None:
        """End every program."""
        if surroundings.pace is not None:
            self.set_speed(math.inf)
            surroundings.pace.resume()
        if self.desk is not None:
            self.desk.scheduler.on_activity = None
            if self._forget is not None:
                self._forget()
            if self._given is None:
                self.desk.close()

    @property
    def threads(self) -> list[int]:
        """The threads that take keys, by their system-wide numbers."""
        thread = self.desk.scheduler.thread_number if self.desk is not None and self._given is None else None
        return [thread] if thread is not None else []

    def windows(self) -> list[Window[object]]:
        """The open windows, oldest first."""
        return self.desk.display.windows if self.desk is not None and self.desk.display is not None else []

    def changed_windows(self) -> list[Window[object]] | None:
        """The open windows if there are others than at the last call, else None."""
        display = self.desk.display if self.desk is not None else None
        if display is None or display.version == self._version:
            return None
        self._version = display.version
        return display.windows

    def terminals(self) -> list[Terminal]:
        """The open terminals, oldest first."""
        return list(self.desk.terminals) if self.desk is not None else []

    def _graph_changed(self, event: object) -> None:
        self._changes += 1
        self._wake()

    def counts(self) -> tuple[int, int]:
        """How many nodes and topics there are, without the hidden ones."""
        changes = self._changes
        if changes != self._counted and self.desk is not None:
            nodes = {node.full_name for node in self.desk.graph.nodes if not node.name.startswith("_")}
            self._counts = (len(nodes), sum("/_" not in name for name in self._topics()))
            self._counted = changes
        return self._counts

    def is_heard(self, name: str) -> bool:
        """Whether a command of ROS (`ros2 topic echo`) listens to a topic."""
        from day6_core.graph.endpoints import EndpointKind

        if self.desk is None:
            return False
        found = self.desk.graph.endpoints(EndpointKind.SUBSCRIPTION, topic=name)
        return any(endpoint.node.name.startswith("_ros2cli") for endpoint in found)

    def _topics(self) -> list[str]:
        from day6_core.graph.endpoints import EndpointKind

        if self.desk is None:
            return []
        return [name for name, _ in self.desk.graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)]

    def doors(self) -> Sequence[Door]:
        """The state of `--listen` and `--connect`; empty without them, or before the link is up."""
        from day6_core.link import doors_of

        return doors_of(self.desk.graph) if self.desk is not None else ()

    def run_tool(self, package: str, executable: str) -> None:
        """Start a program of ours that belongs to the desktop, not to a terminal; it ends when its window is closed."""
        from day6_core.ros.programs import load

        self.start(executable, load(package, executable))

    def start(self, name: str, main: Main) -> None:
        """Start a program, by its main function, that belongs to the desktop."""
        if self.desk is not None:
            self.desk.start_unseen(name, main)

    # -- time ----------------------------------------------------------------------------------------------------------

    @property
    def is_virtual(self) -> bool:
        """Whether speed and pause are those of all programs, also of the user's own."""
        return surroundings.pace is not None

    @property
    def paused(self) -> bool:
        if surroundings.pace is not None:
            return surroundings.pace.paused
        return self.desk is not None and bool(self.desk.clock.paused)

    @property
    def speed(self) -> float:
        """Seconds of the world in a real one; infinity is as fast as it can."""
        if surroundings.pace is not None:
            return surroundings.pace.speed
        return float(self.desk.clock.speed) if self.desk is not None else 1.0

    def toggle_pause(self) -> None:
        """Pause or resume the world."""
        if surroundings.pace is not None:
            (surroundings.pace.resume if self.paused else surroundings.pace.pause)()
        elif self.desk is not None:
            (self.desk.resume if self.paused else self.desk.pause)()

    def change_speed(self, step: int) -> float:
        """Go to the next speed up or down (0: to normal) and return it."""
        speeds: tuple[float, ...] = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
        if surroundings.pace is not None:
            speeds = (*speeds, math.inf)
        if step:
            now = speeds.index(self.speed) if self.speed in speeds else speeds.index(1.0)
            speed = speeds[max(0, min(len(speeds) - 1, now + step))]
        else:
            speed = 1.0
        self.set_speed(speed)
        return speed

    def set_speed(self, speed: float) -> None:
        """Let time pass at one of the speeds."""
        if surroundings.pace is not None:
            surroundings.pace.set_speed(speed)
        elif self.desk is not None:
            self.desk.set_speed(speed)

    def step(self, seconds: float) -> None:
        """Let so much time pass while it is paused."""
        if surroundings.pace is not None:
            surroundings.pace.step(seconds)
        elif self.desk is not None:
            self.desk.step(seconds)
