"""What checks look at: the running machine, as it is now and as it was since the step began.

Topics are listened to through a hidden node, only those that a check asks about, and only while somebody publishes them: a
subscription would make the topic.
"""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.graph.endpoints import EndpointKind
from day6_core.graph.names import OBSERVER_PREFIX, full_name
from rclpy.qos import QoSDurabilityPolicy, QoSProfile, QoSReliabilityPolicy

if TYPE_CHECKING:
    from day6_core.graph.graph import Graph
    from day6_core.session.display import Window
    from day6_core.session.session import Session
    from day6_core.shell.desk import Desk
    from day6_core.shell.runs import Ran, Run
    from day6_core.shell.terminal import Terminal
    from rclpy.node import Node
    from rclpy.subscription import MessageInfo, Subscription

KEPT = 500
"""Messages that are kept of a topic."""

ASK_SECONDS = 0.5
"""Between two questions for the same parameter."""


class Arrival(NamedTuple):
    """One message, when it came (ns of real time), and the full name of the node that sent it ('': it has ended)."""

    when: int
    message: Any
    sender: str


class OutsideHome(OSError):
    """A path of a lesson that leaves the home folder."""

    def __init__(self, path: object) -> None:
        super().__init__(f"{path} is not in the home folder")


class Heard:
    """The messages of one topic: the last ones, and how many there were in all."""

    def __init__(self) -> None:
        self.count = 0
        self._last: deque[Arrival] = deque(maxlen=KEPT)

    def add(self, arrival: Arrival) -> None:
        self.count += 1
        self._last.append(arrival)

    def since(self, count: int) -> list[tuple[int, Any]]:
        """When the messages after the first `count` came, and they themselves, as far as they are kept."""
        return [(each.when, each.message) for each in self.arrivals(count)]

    def arrivals(self, count: int) -> list[Arrival]:
        """The arrivals after the first `count`, as far as they are kept, with who sent them."""
        new = self.count - count
        return list(self._last)[-new:] if new > 0 else []


class Live:
    """The machine for the checks of one lesson. Used on the scheduler's thread.

    Without a session it tells how things are, on any thread, and nothing of messages and parameters. `since_ns`: since when what
    is typed counts (epoch nanoseconds), if that is not from now on.
    """

    def __init__(self, desk: Desk, session: Session | None, folder: Path, since_ns: int | None = None) -> None:
        self.desk = desk
        self._session = session
        self.folder = folder
        """Where the lesson lies."""
        self.answer = ""
        """The letter the pupil chose in this step."""
        self.remembered: dict[str, Any] = {}
        """What the check that is asked now remembers of this step."""
        self._memories: dict[int, tuple[object, dict[str, Any]]] = {}
        self._node: Node | None = None
        self._arrived = 0
        self._heard: dict[str, Heard] = {}
        self._subscriptions: dict[str, tuple[Subscription[Any], str]] = {}
        self._lasting: set[str] = set()
        """Topics whose last messages come to who listens later."""
        self._parameters: dict[tuple[str, str], tuple[int, Any]] = {}
        self._asked: dict[tuple[str, str], int] = {}
        self.lesson_began_ns = self.step_began_ns = self.now_ns() if since_ns is None else since_ns

    @property
    def session(self) -> Session:
        """The program that listens and asks."""
        assert self._session is not None, "this looks only at how things are"
        return self._session

    # -- time and memory -----------------------------------------------------------------------------------------------

    def now_ns(self) -> int:
        """Real time, which stamps and arrivals have."""
        return self.desk.clock.now_ns()

    def began_ns(self, since: str) -> int:
        """When the lesson began, or with 'step' the step."""
        return self.step_began_ns if since == "step" else self.lesson_began_ns

    def begin_step(self, since_ns: int | None = None) -> None:
        """Forget what the checks remembered: a new step begins, now or at a moment before."""
        self._memories.clear()
        self.answer = ""
        self.step_began_ns = self.now_ns() if since_ns is None else since_ns
        for topic, heard in list(self._heard.items()):
            last = heard.arrivals(heard.count - 1) if topic in self._lasting else []
            self._heard[topic] = Heard()
            for each in last:  # what is sent once for all who come later does not come again
                self._heard[topic].add(each)

    def memory(self, owner: object) -> dict[str, Any]:
        """A dictionary of this owner for this step."""
        return self._memories.setdefault(id(owner), (owner, {}))[1]

    # -- the graph -----------------------------------------------------------------------------------------------------

    @property
    def graph(self) -> Graph:
        return self.desk.graph

    @property
    def node(self) -> Node:
        """The hidden node that listens; made when it is first needed."""
        if self._node is None:
            name = f"{OBSERVER_PREFIX}_lesson_{self.session.pid}"
            self._node = self.session.create_node(name, start_parameter_services=False)
            self.session.spawn(self.session.spin(self._node))
        return self._node

    def nodes(self) -> list[str]:
        """Full names of the nodes, hidden ones left out; one for each, so that doubles count."""
        return sorted(
            full_name(node.namespace, node.name) for node in self.graph.nodes if not node.name.startswith("_")
        )

    def topics(self) -> dict[str, list[str]]:
        """Topics and their types, hidden ones left out."""
        found = self.graph.names_and_types(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION)
        return {name: types for name, types in found if not _hidden(name) and self._ends(name)}

    @property
    def stirring(self) -> object:
        """Something that is another one as soon as there is news: output, a node, a message that a check listens to."""
        return tuple((each, each.version) for each in self.desk.terminals), self.graph.nodes, self._arrived

    def publishers(self, topic: str) -> list[str]:
        """Full names of the nodes that publish a topic, one for each publisher."""
        return self._nodes_of(EndpointKind.PUBLISHER, topic)

    def subscribers(self, topic: str) -> list[str]:
        """Full names of the nodes that subscribe to a topic, one for each subscription."""
        return self._nodes_of(EndpointKind.SUBSCRIPTION, topic)

    def servers(self, service: str) -> list[str]:
        return self._nodes_of(EndpointKind.SERVICE, service)

    def _ends(self, topic: str) -> bool:
        return bool(self.publishers(topic) or self.subscribers(topic))

    def _nodes_of(self, kind: EndpointKind, topic: str) -> list[str]:
        return sorted(
            full_name(end.node.namespace, end.node.name)
            for end in self.graph.endpoints(kind, topic=topic)
            if not end.node.name.startswith("_day6")
        )

    # -- messages ------------------------------------------------------------------------------------------------------

    def heard(self, topic: str) -> Heard:
        """What came on a topic since the step began; asking is listening from now on."""
        heard = self._heard.setdefault(topic, Heard())
        self._listen(topic)
        return heard

    def _listen(self, topic: str) -> None:
        # Also where there are only subscribers: somebody may publish once and be gone before the next look.
        ends = self.graph.endpoints(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION, topic=topic)
        types = {end.type_name for end in ends}
        known = self._subscriptions.get(topic)
        if known is not None and known[1] not in types:
            self.node.destroy_subscription(known[0])
            del self._subscriptions[topic]
        elif known is not None and topic not in self._lasting and self._is_lasting(topic):
            self.node.destroy_subscription(self._subscriptions.pop(topic)[0])
            self._subscribe(topic, known[1])
        elif known is None and types:
            self._subscribe(topic, sorted(types)[0])

    def _subscribe(self, topic: str, type_name: str) -> None:
        from rosidl_runtime_py.utilities import get_message

        try:
            kind = get_message(type_name)
        except (AttributeError, ModuleNotFoundError, ValueError):
            return  # a type of the pupil's workspace: its package is not on this process's path
        lasting = self._is_lasting(topic)
        (self._lasting.add if lasting else self._lasting.discard)(topic)
        durability = QoSDurabilityPolicy.TRANSIENT_LOCAL if lasting else QoSDurabilityPolicy.VOLATILE
        reliability = QoSReliabilityPolicy.RELIABLE if lasting else QoSReliabilityPolicy.BEST_EFFORT
        qos = QoSProfile(depth=100, durability=durability, reliability=reliability)

        def take(message: Any, info: MessageInfo) -> None:
            sender = self._sender(topic, info["publisher_gid"])
            self._heard.setdefault(topic, Heard()).add(Arrival(self.now_ns(), message, sender))
            self._arrived += 1

        self._subscriptions[topic] = self.node.create_subscription(kind, topic, take, qos), type_name

    def _sender(self, topic: str, gid: Mapping[str, Any] | None) -> str:
        ends = self.graph.endpoints(EndpointKind.PUBLISHER, topic=topic)
        return next((end.node.full_name for end in ends if gid is not None and end.gid == gid["data"]), "")

    def _is_lasting(self, topic: str) -> bool:
        """Whether everybody who publishes it keeps the last messages for who comes later."""
        offered = [info.qos_profile.durability for info in self.node.get_publishers_info_by_topic(topic)]
        return bool(offered) and all(each == QoSDurabilityPolicy.TRANSIENT_LOCAL for each in offered)

    def parameter(self, node: str, name: str) -> tuple[bool, Any]:
        """Whether the node has answered lately, and the parameter's value (None: it has none of that name)."""
        key = (node, name)
        now = self.desk.clock.steady_ns()
        if now - self._asked.get(key, -(10**18)) > ASK_SECONDS * 1e9:
            self._asked[key] = now
            self.session.spawn(self._ask(node, name))
        when, value = self._parameters.get(key, (-(10**18), None))
        return now - when < 6 * ASK_SECONDS * 1e9, value

    async def _ask(self, node: str, name: str) -> None:
        from rcl_interfaces.srv import GetParameters

        from rclpy.parameter import parameter_value_to_python

        client = self.node.create_client(GetParameters, f"{node}/get_parameters")
        try:
            if not client.service_is_ready():
                return
            future = client.call_async(GetParameters.Request(names=[name]))
            if await self.session.spin_until(future, 1.0) and (answer := future.result()) is not None:
                values = answer.values
                value = parameter_value_to_python(values[0]) if values else None
                self._parameters[node, name] = self.desk.clock.steady_ns(), value
        finally:
            self.node.destroy_client(client)

    # -- terminals and windows -----------------------------------------------------------------------------------------

    @property
    def terminals(self) -> list[Terminal]:
        return [terminal for terminal in self.desk.terminals if not terminal.closed]

    def runs(self, since_ns: int, *, new: bool = False) -> list[Run]:
        """The lines that were run in all terminals, or still ran, after a moment; the oldest first.

        `new`: only those of terminals whose very first line was run after it.
        """
        found = [
            run
            for all_runs in self._all_runs()
            for run in all_runs
            if (run.ended_ns is None or run.ended_ns >= since_ns) and (not new or _is_new(all_runs, since_ns))
        ]
        return sorted(found, key=lambda run: run.began_ns)

    def _all_runs(self) -> Iterator[list[Run]]:
        """The lines of each terminal, of those that are closed, too."""
        for runs in [*self.desk.closed_runs, *(terminal.runs for terminal in self.desk.terminals)]:
            if lines := runs.all:
                yield lines

    def commands(self, since_ns: int, *, new: bool = False) -> list[Ran]:
        """The simple commands that were run in all terminals, or still ran, after a moment; the oldest first."""
        found = [
            ran
            for all_runs in self._all_runs()
            if not new or _is_new(all_runs, since_ns)
            for run in all_runs
            if run.over_ns is None or run.over_ns >= since_ns
            for ran in list(run.commands)
            if ran.ended_ns is None or ran.ended_ns >= since_ns
        ]
        return sorted(found, key=lambda ran: ran.began_ns)

    def unfinished(self) -> list[Ran]:
        """The simple commands that run now, in the foreground or the background."""
        return [ran for ran in self.commands(self.now_ns()) if ran.ended_ns is None]

    def places(self, since_ns: int) -> list[list[Path]]:
        """For each terminal the folders in which its commands were run after a moment, and the one where it is now."""
        return [
            [ran.cwd for run in terminal.runs.all for ran in list(run.commands) if ran.began_ns >= since_ns]
            + [terminal.shell.cwd]
            for terminal in self.terminals
        ]

    def running(self) -> list[str]:
        """The lines that run now, in the foreground or the background."""
        return [" ".join(line.split()) for terminal in self.terminals for line in terminal.running]

    def variables(self) -> list[dict[str, str]]:
        """The variables of each terminal."""
        return [dict(terminal.shell.environment) for terminal in self.terminals]

    def windows(self, kind: str | None = None) -> list[Window[object]]:
        """The open windows (of one kind), oldest first."""
        display = self.desk.display
        return [each for each in (display.windows if display is not None else []) if kind in (None, each.kind)]

    # -- files ---------------------------------------------------------------------------------------------------------

    @property
    def home(self) -> Path:
        """The home folder of the pupil: a drill has one of its own."""
        return self.desk.login_home

    def path(self, text: str) -> Path:
        """The file that a lesson means: below the home folder. Raises OutsideHome for any other."""
        path = self.home / text[2:] if text.startswith("~/") else self.home if text == "~" else self.home / text
        home, meant = (Path(os.path.normpath(each)) for each in (self.home, path))
        if meant != home and home not in meant.parents:
            raise OutsideHome(text)
        return path

    def close(self) -> None:
        """Stop listening."""
        if self._node is not None:
            self._node.destroy_node()
            self._node = None


def _is_new(lines: Sequence[Run], since_ns: int) -> bool:
    """Whether the very first line of a terminal was run after a moment."""
    return lines[0].number == 1 and lines[0].began_ns >= since_ns


def _hidden(name: str) -> bool:
    return any(part.startswith("_") for part in name.split("/"))


def first(found: Iterable[str], matches: Callable[[str], bool]) -> str | None:
    """The first that matches."""
    return next((each for each in found if matches(each)), None)
