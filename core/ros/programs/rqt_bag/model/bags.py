"""What the window of rqt_bag shows: the open bags on their timeline, the player, and what is going on with them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_tui.core.interfaces import DeserializationError, UnknownInterfaceError, deserialize, get_interface
from day6_tui.core.ros.programs.rqt_bag.model.loading import OpenBag, index_bag, open_bag
from day6_tui.core.ros.programs.rqt_bag.model.player import Player
from day6_tui.core.ros.programs.rqt_bag.model.timeline import Timeline
from day6_tui.core.session.task import Signal
from day6_tui.core.session.threads import in_thread

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session
    from rclpy.node import Node

MOST_SHOWN = 8_000_000
"""Bytes of a message that is shown as a tree: reading a larger one would hold up the window."""


class Shown(NamedTuple):
    """The message of a topic at the playhead: its type, when it was received, and itself or why it can't be read."""

    type: str
    time_ns: int
    message: Any | None
    problem: str = ""


class Bags:
    """The model. The window reads its attributes and calls the methods of its side, on any thread."""

    def __init__(self, session: Session, node: Node, *, publish_clock: bool = False) -> None:
        self._session = session
        self._node = node
        self.timeline = Timeline()
        self.player = Player(node, self.timeline, session.clock.steady_ns, publish_clock=publish_clock)
        self.bags: tuple[OpenBag, ...] = ()
        self.topics: dict[str, str] = {}
        """The types of the topics of all bags, by name, sorted."""
        self.rates: dict[str, float | None] = {}
        """Messages per second of each topic, between its first and its last one; None where that says nothing."""
        self.status = ""
        """What is going on, or went wrong, in the words of rqt_bag; '' for nothing."""
        self.failed = False
        """Whether `status` tells what went wrong."""
        self.loading = False
        self._version = 0
        self._requests: deque[Callable[[], object]] = deque()
        self._wanted, self._loads, self._looks = Signal(), Signal(), Signal()
        self._to_load: deque[str] = deque()
        self._in_sight: tuple[int, int] | None = None
        self._closed = self._has_begun = False
        self._shown: dict[str, Shown] = {}

    @property
    def version(self) -> int:
        """Grows with everything that a window shows but the time of the playhead."""
        return self._version + self.timeline.version + self.player.version

    @property
    def size(self) -> int:
        """Bytes of all bags."""
        return sum(bag.size for bag in self.bags)

    # -- the window's side ---------------------------------------------------------------------------------------------

    def request(self, action: Callable[[], object]) -> None:
        """Have `action` called by the program: whatever changes the player."""
        self._requests.append(action)
        self._wanted.set()

    def load(self, path: str) -> None:
        """Open a bag and add it to the timeline."""
        self._to_load.append(path)
        self._loads.set()

    def see(self, left_ns: int, right_ns: int) -> None:
        """This part of the timeline is in sight: single messages are looked up, where they can be told apart."""
        self._in_sight = (left_ns, right_ns)
        self._looks.set()

    def toggle_publishing(self, topic: str) -> None:
        """Publish a topic, or stop that."""
        player = self.player
        self.request(lambda: (player.stop_publishing if topic in player.publishing else player.start_publishing)(topic))

    def publish_all(self, on: bool) -> None:
        """Publish all topics, or none."""
        self.request(lambda: [self._publish(topic, on) for topic in self.topics])

    def _publish(self, topic: str, on: bool) -> None:
        (self.player.start_publishing if on else self.player.stop_publishing)(topic)

    def shown(self, topic: str) -> Shown | None:
        """The message of a watched topic at the playhead; None if there is none, or it is not read yet."""
        found = self.player.current.get(topic)
        if found is None:
            return None
        before = self._shown.get(topic)
        if before is not None and before.time_ns == found.received_ns:
            return before
        kind = self.topics.get(topic, "")
        if len(found.data) > MOST_SHOWN:
            after = Shown(kind, found.received_ns, None, f"{len(found.data)} bytes")
        else:
            try:
                after = Shown(kind, found.received_ns, deserialize(found.data, get_interface(kind)))
            except (DeserializationError, UnknownInterfaceError, ValueError, LookupError) as error:
                after = Shown(kind, found.received_ns, None, str(error))
        self._shown[topic] = after
        return after

    # -- the program's side --------------------------------------------------------------------------------------------

    async def serve(self) -> None:
        """Carry out requests, for ever. Scrubbing is not to wait for the world, so this waits for nothing else."""
        while True:
            self._wanted.clear()
            while self._requests:
                self._requests.popleft()()
                self._version += 1
            await self._session.wait(self._wanted)

    async def serve_loads(self) -> None:
        """Open bags, one after the other, for ever."""
        while True:
            await self._session.wait(self._loads)
            self._loads.clear()
            while self._to_load:
                await self._load(self._to_load.popleft())

    async def serve_looks(self) -> None:
        """Look up the messages in sight, for ever."""
        while True:
            await self._session.wait(self._looks)
            self._looks.clear()
            if self._in_sight is not None:
                await self._look(*self._in_sight)

    def tell(self, text: str, *, failed: bool = False) -> None:
        """Show a line of text."""
        self.status, self.failed = text, failed
        self._version += 1

    async def _load(self, name: str) -> None:
        path = Path(self._session.cwd, name).expanduser()
        self.tell(f"Loading '{name}' ...")
        self.loading = True
        try:
            bag = await in_thread(lambda: open_bag(path))
            self._add(bag)
            await in_thread(lambda: index_bag(bag, self.timeline, lambda: self._closed))
            self._began()
            rates = await in_thread(lambda: {topic: self.timeline.rate(topic) for topic in bag.topics})
            self.rates = {**self.rates, **rates}
            self.tell("" if bag.is_complete else f"'{name}' is not complete: it is shown as far as it goes")
        except (RuntimeError, OSError) as error:
            reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
            self.tell(f"Loading '{name}' failed due to: {reason}", failed=True)
        finally:
            self.loading = False
            self._refresh()

    def _add(self, bag: OpenBag) -> None:
        for topic in bag.topics.values():
            before = self.topics.get(topic.name, topic.type)
            if before != topic.type:
                raise RuntimeError(f"topic {topic.name} has multiple datatypes: {before} and {topic.type}")
        self.bags = (*self.bags, bag)
        if bag.start_ns is not None and bag.end_ns is not None:
            self.timeline.span(bag.start_ns, bag.end_ns)
        self._refresh()
        self._began()

    def _began(self) -> None:
        """The playhead of the first bag is at its beginning."""
        if not self._has_begun and self.timeline.start_ns is not None:
            self._has_begun = True
            self.player.jump(self.timeline.start_ns)

    def _refresh(self) -> None:
        topics = {topic.name: topic for bag in reversed(self.bags) for topic in bag.topics.values()}
        self.player.topics = topics
        self.topics = {name: topics[name].type for name in sorted(topics)}
        self._version += 1

    async def _look(self, left: int, right: int) -> None:
        try:
            await in_thread(lambda: self.timeline.look_at(left, right))
        except (RuntimeError, OSError) as error:
            self.tell(str(error), failed=True)

    def close(self) -> None:
        """Stop publishing, and close the files."""
        self._closed = True
        self.player.close()
        for bag in self.bags:
            bag.close()
