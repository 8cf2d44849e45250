"""Gathers the facts and keeps the findings: the model of the window.

The graph is looked at through a node that only looks on; terminals, windows and files through what the session has of the
machine; what happens inside other processes by asking them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Protocol

from day6_core.facts.graph import facts_of, is_shown
from day6_core.link.state import LinkState
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.files import Files, Typed, Where
from day6_core.ros.programs.day6_inspector.finding import Finding
from day6_core.ros.programs.day6_inspector.hearing import Hearing
from day6_core.ros.programs.day6_inspector.listening import JOINT_STATES, Listening
from day6_core.ros.programs.day6_inspector.pace import ClockPace
from day6_core.ros.programs.day6_inspector.process_reports import ReportedProcess
from day6_core.ros.programs.day6_inspector.program_rules import home_of, script_of, typed_as
from day6_core.ros.programs.day6_inspector.publications import Publications
from day6_core.ros.programs.day6_inspector.rules import RULES, findings
from day6_core.ros.programs.day6_inspector.sight import not_seen, sights
from day6_core.ros.programs.day6_inspector.windows import rviz_views, watched, world_remarks

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph
    from day6_core.session.clock import WorldClock
    from day6_core.session.overview import Overview, TerminalView
    from rclpy.node import Node


COUNTED_AGAIN = 10
"""Looks after which what was looked at is counted again although nothing else has changed: the window needn't flicker."""


ASKED = 3
"""Looks after which a program that has told nothing of itself counts as one that doesn't: it may have just begun."""


class ProcessReports(Protocol):
    """Asks the other processes (`asking.Asking`)."""

    @property
    def processes(self) -> tuple[ReportedProcess, ...]: ...

    def silent(self) -> tuple[str, ...]:
        """Return nodes of processes that do not answer."""

    def ask(self) -> None: ...

    def hear(self) -> None: ...


class Inspector:
    """The model of the window: when the findings change, `findings` is replaced as a whole and `version` incremented."""

    def __init__(
        self,
        node: Node,
        clock: WorldClock,
        graph: Graph,
        link: Callable[[], LinkState] = LinkState,
        *,
        overview: Overview | None = None,
        reports: ProcessReports | None = None,
    ) -> None:
        self._clock = clock
        self._link = link
        self._graph = graph
        self._overview = overview
        self._reports = reports
        self._files: Files | None = None
        self._clock_pace = ClockPace(clock)
        self._pace = clock.speed
        self._listening = Listening(node)
        self._hearing = Hearing(node.handle.node)
        self._publications = Publications(graph)
        self.findings: tuple[Finding, ...] = ()
        self.looked: tuple[tuple[str, int], ...] = ()
        """What was looked at (`sight.SIGHTS`), and how many of it there are."""
        self.unseen: tuple[tuple[str, str], ...] = ()
        """What could not be looked at: 'terminals', 'files', 'programs', 'messages', 'topics', and the names it is about."""
        self.quiet = ""
        """'drill' or 'exam' while nothing is said because the pupil is to find a fault himself."""
        self.version = 0
        self._looks = COUNTED_AGAIN
        self._untold: dict[str, int] = {}
        """Nodes of other processes that told nothing, and at how many looks in a row."""

    def close(self) -> None:
        """Stop following the graph."""
        self._publications.close()

    def refresh(self) -> None:
        """Look again (on the program's thread)."""
        self._pace = self._clock_pace.now()
        self._listening.listen()
        self._hearing.look()
        self._note_untold()
        self._looks += 1
        if self._reports is not None:
            self._reports.ask()
        self.judge()

    def judge(self) -> None:
        """Judge again what is known; other processes' answers to the last question are taken first."""
        if self._reports is not None:
            self._reports.hear()
        quiet = self._overview.searching if self._overview is not None else ""
        facts = self.facts()
        home = str(self._overview.home) if self._overview is not None else ""
        found = () if quiet else tuple(each.at_home(home) for each in findings(facts))
        unseen = () if quiet else not_seen(facts)
        if (quiet, found, unseen) != (self.quiet, self.findings, self.unseen):
            self.quiet, self.findings, self.unseen = quiet, found, unseen
            self.version += 1
            self._looks = COUNTED_AGAIN
        if self._looks >= COUNTED_AGAIN:
            self.count(facts)

    def count(self, facts: Facts | None = None) -> None:
        """Count what is looked at now."""
        self._looks, looked = 0, () if self.quiet else sights(RULES, facts or self.facts())
        if looked != self.looked:
            self.looked = looked
            self.version += 1

    # -- files: in a thread --------------------------------------------------------------------------------------------

    def where(self) -> Where | None:
        """Return where to look for files now; None where nobody tells about terminals."""
        if self._overview is None:
            return None
        terminals = self._overview.terminals()
        typed = [(each, source) for each in terminals for source in each.running]
        typed += [(each, line.source) for each in terminals for line in each.lines if line.status is None]
        lines = [typed_as(each, source) for each, source in typed]
        if self._reports is not None:
            lines += [Typed(" ".join(each.arguments), (), self._overview.home) for each in self._reports.processes]
        last = [(each.lines[-1], home_of(each)) for each in terminals if each.lines]
        scripts = [script_of(line.source, line.cwd, home) for line, home in last if line.status == 0]
        return Where(
            self._overview.home,
            tuple((each.number, each.cwd, dict(each.variables)) for each in terminals),
            tuple(dict.fromkeys(lines)),
            tuple(script for script in scripts if script is not None),
        )

    def take_files(self, files: Files) -> None:
        """Take what `files.look` found."""
        self._files = files

    # -- all facts -----------------------------------------------------------------------------------------------------

    def facts(self) -> Facts:
        """Return what is known now, without hidden nodes and topics."""
        heard = self._listening
        overview, windows = self._overview, self._overview.windows() if self._overview is not None else ()
        seen = facts_of(self._graph, overview.domains() if overview is not None else None)
        published = JOINT_STATES in seen.publishers
        processes = self._reports.processes if self._reports is not None else ()
        rate = heard.rate()
        return Facts(
            **vars(seen),
            missed=self._missed(processes),
            rates={JOINT_STATES: rate} if rate is not None else {},
            heard_joints=heard.joint_names if published else (),
            unequal_joints=heard.unequal if published else None,
            timeless_joints=heard.timeless and published,
            joints=heard.joints,
            robot=heard.robot,
            **self._hearing.facts(),
            link=self._link(),
            speed=self._clock.speed,
            pace=self._pace,
            rviz=rviz_views(windows),
            world=world_remarks(windows),
            terminals=self._terminals(),
            now_ns=self._clock.now_ns(),
            files=self._files,
            processes=processes,
            windows=watched(windows),
            unreported=tuple(sorted(node for node, looks in self._untold.items() if looks >= ASKED)),
            silent_processes=self._reports.silent() if self._reports is not None else (),
        )

    def _terminals(self) -> tuple[TerminalView, ...] | None:
        return tuple(self._overview.terminals()) if self._overview is not None else None

    def _note_untold(self) -> None:
        """Count for how many looks the nodes of other processes have told nothing of their insides."""
        processes = self._reports.processes if self._reports is not None else ()
        told = {inside.node for process in processes for inside in process.nodes}
        others = {node.full_name for node in self._graph.nodes if node.origin is not None and is_shown(node.name)}
        self._untold = {node: self._untold.get(node, 0) + 1 for node in others - told}

    def _missed(self, processes: tuple[ReportedProcess, ...]) -> tuple[tuple[str, str, float], ...]:
        received: Mapping[tuple[str, str], int] = {
            (inside.node, topic): count
            for process in processes
            for inside in process.nodes
            for topic, count in inside.subscriptions.items()
        }
        return self._publications.missed(received, processes)
