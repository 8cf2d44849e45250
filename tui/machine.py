"""The desktop's connection to the simulated machine: starts and ends it, wakes the frames when it did something, counts."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from day6_tui.core.link.state import Door


class Machine:
    """Holds the desk (None before it has started) and what the frame of the desktop shows of it."""

    def __init__(self, desk: Any, *, wake: Callable[[], None]) -> None:
        self.desk: Any = None
        self._given = desk
        self._wake = wake
        self._version = -1
        self._counts = (0, 0)
        self._changes = 0
        self._counted = -1
        """After how many changes of the graph `_counts` was counted; they come on other threads, also while one counts."""
        self._forget: Callable[[], None] | None = None

    def open(self, options: Any) -> None:
        """Start it. Raises OSError if the home folder cannot be used."""
        desk = self._given
        if desk is None:
            from day6_tui.core.shell.desk import Desk

            home = getattr(options, "home", None)
            desk = Desk(
                Path(home) if home else None,
                listen=getattr(options, "listen", None),
                connect=getattr(options, "connect", None),
                secret=getattr(options, "secret", None),
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

    def robot_words(self, options: Any) -> dict[str, str]:
        """What the car scene types: `robot`, the URDF file, and `fetch`, which first copies the shipped one ('' if not needed).

        The copy in the home folder is the student's own: it can be edited, and is never overwritten.
        """
        given = getattr(options, "robot", None)
        if given:
            return {"robot": shlex.quote(str(Path(given).expanduser().resolve())), "fetch": ""}
        from day6_tui.urdf.shipped import shipped_model

        model = shipped_model()
        there = (Path(self.desk.home) / model.name).exists()
        return {"robot": f"~/{model.name}", "fetch": "" if there else f"cp {shlex.quote(str(model))} ~"}

    def hurry(self) -> None:
        """Let `close` wait for no program any more. Any thread; before it as well as while it runs."""
        if self.desk is not None and self._given is None:
            self.desk.hurry()

    def close(self) -> None:
        """End every program."""
        if self.desk is not None:
            self.desk.scheduler.on_activity = None
            if self._forget is not None:
                self._forget()
            if self._given is None:
                self.desk.close()

    def changed_windows(self) -> list[Any] | None:
        """The open windows if there are others than at the last call."""
        display = self.desk.display
        if display.version == self._version:
            return None
        self._version = display.version
        return list(display.windows)

    def _graph_changed(self, event: object) -> None:
        self._changes += 1
        self._wake()

    def counts(self) -> tuple[int, int]:
        """How many nodes and topics there are, without the hidden ones."""
        changes = self._changes
        if changes != self._counted:
            from day6_tui.core.graph.endpoints import EndpointKind

            graph = self.desk.graph
            nodes = {node.full_name for node in graph.nodes if not node.name.startswith("_")}
            topics = graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
            self._counts = (len(nodes), sum("/_" not in name for name, _ in topics))
            self._counted = changes
        return self._counts

    def doors(self) -> Sequence[Door]:
        """How it stands with `--listen` and `--connect`; empty without them, or before the link is there."""
        from day6_tui.core.link import doors_of

        return doors_of(self.desk.graph)

    def run_tool(self, package: str, executable: str) -> None:
        """Start a program of ours that belongs to the desktop, not to a terminal; it ends when its window is closed."""
        from day6_tui.core.ros.programs import load
        from day6_tui.core.session.streams import InputStream, OutputStream
        from day6_tui.core.shell.language.redirection import Streams

        desk = self.desk
        streams = Streams(InputStream(), OutputStream(), OutputStream())

        def start() -> None:
            desk.start_program([executable], load(package, executable), streams, env=desk.environment(), cwd=desk.home)

        desk.scheduler.call_soon_threadsafe(start)

    # -- time ----------------------------------------------------------------------------------------------------------

    @property
    def paused(self) -> bool:
        return self.desk is not None and bool(self.desk.clock.paused)

    @property
    def speed(self) -> float:
        return float(self.desk.clock.speed) if self.desk is not None else 1.0

    def toggle_pause(self) -> None:
        """Let the world stand still or run on."""
        if self.desk is not None:
            (self.desk.resume if self.paused else self.desk.pause)()

    def change_speed(self, step: int) -> float:
        """Go to the next speed up or down (0: to normal) and return it."""
        speeds = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
        if step:
            now = min(range(len(speeds)), key=lambda index: abs(speeds[index] - self.speed))
            speed = speeds[max(0, min(len(speeds) - 1, now + step))]
        else:
            speed = 1.0
        if self.desk is not None:
            self.desk.set_speed(speed)
        return speed
