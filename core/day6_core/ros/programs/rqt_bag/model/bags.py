"""What the window of rqt_bag shows: the open bags on their timeline, the player, and what is going on with them."""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Callable, Coroutine, Iterable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.interfaces import DeserializationError, UnknownInterfaceError, deserialize, get_interface
from day6_core.reason import reason
from day6_core.ros.programs.rqt_bag.model.exporting import ExportError, export
from day6_core.ros.programs.rqt_bag.model.keeping import Kept
from day6_core.ros.programs.rqt_bag.model.loading import OpenBag, index_bag, is_bag, open_bag
from day6_core.ros.programs.rqt_bag.model.pictures import IMAGE, NoPicture, Picture, picture
from day6_core.ros.programs.rqt_bag.model.player import Player
from day6_core.ros.programs.rqt_bag.model.recorder import POLL_SECONDS, Recorder
from day6_core.ros.programs.rqt_bag.model.timeline import Timeline
from day6_core.ros.programs.rqt_bag.model.view import TimeSpan
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from rosbag2_py._storage import Message

    from day6_core.session.session import Session
    from rclpy.node import Node

MOST_SHOWN = 8_000_000
"""Bytes of a message that is shown as a tree: reading a larger one would hold up the window."""

MOST_PICTURES = 256
"""Pictures that are kept."""

MOST_MISSING = 64
"""Pictures that wait to be read: more are not in sight."""


class ShownMessage(NamedTuple):
    """The message of a topic at the playhead: its type, when it was received, and itself or why it can't be read."""

    type: str
    time_ns: int
    message: object | None
    problem: str = ""


class Note(NamedTuple):
    """What the window says of a bag in its user's language, where rqt_bag has no words for it: "cut", "cancelled" or "empty"."""

    kind: str
    name: str


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
        self.status: str | Note = ""
        """What is going on, or went wrong, in the words of rqt_bag if it has any; '' for nothing."""
        self.failed = False
        """Whether `status` tells what went wrong."""
        self.loading = False
        self.view: TimeSpan | None = None
        """What part of the timeline is seen; None for everything, however the bags grow."""
        self.thumbnails = False
        """Whether images are shown along the line of their topic."""
        self._resumed = Kept()
        """How bags that are still to be loaded were looked at."""
        self._version = 0
        self._requests: deque[Callable[[], object]] = deque()
        self._wanted, self._loads, self._looks = Signal(), Signal(), Signal()
        self._to_load: deque[tuple[str, str]] = deque()
        self._in_sight: tuple[int, int] | None = None
        self._closed = self._has_begun = False
        self._shown: dict[str, tuple[Message, ShownMessage]] = {}
        self.recorder: Recorder | None = None
        self.exporting: int | None = None
        """Per cent of an export, None without one."""
        self.exporting_to = ""
        """What it does, in the words of rqt_bag."""
        self._exports: tuple[str, Sequence[str], tuple[int, int]] | None = None
        self._cancelled = False
        self._records, self._wanted_export, self._wanted_pictures = Signal(), Signal(), Signal()
        self._pictures: OrderedDict[tuple[str, int, int, int], Picture | None] = OrderedDict()
        self._missing: deque[tuple[str, int, int, int]] = deque(maxlen=MOST_MISSING)

    @property
    def version(self) -> int:
        """Grows with everything that a window shows but the time of the playhead."""
        return self._version + self.timeline.version + self.player.version

    @property
    def size(self) -> int:
        """Bytes of all bags."""
        return sum(bag.size for bag in self.bags)

    @property
    def indexed(self) -> int | None:
        """Per cent of the bag that is loaded that are in the index; None while none is."""
        return int(100 * self.bags[-1].passed) if self.loading and self.bags else None

    # -- perspectives --------------------------------------------------------------------------------------------------

    def kept(self) -> Kept:
        """What is open, and how it is looked at."""
        if not self.bags or self._resumed.bags:
            return self._resumed._replace(thumbnails=self.thumbnails)
        player = self.player
        return Kept(
            tuple(str(bag.path) for bag in self.bags),
            tuple(sorted(player.publishing)),
            player.now(),
            player.region,
            self.view,
            self.thumbnails,
        )

    def resume(self, kept: Kept) -> None:
        """Open the bags of a perspective, and look at them as they were looked at."""
        self._resumed, self.thumbnails = kept, kept.thumbnails
        for path in kept.bags:
            self.load(path)

    def _look_as_before(self) -> None:
        kept, self._resumed = self._resumed, Kept()
        if not any(str(bag.path) in kept.bags for bag in self.bags):
            return  # it was not there any more, and the user has opened another one
        self.view = kept.view
        if kept.region is not None:
            self.player.select(kept.region)
        self._publish([topic for topic in kept.publishing if topic in self.topics], True)
        if kept.playhead is not None and self.timeline.start_ns is not None and self.timeline.end_ns is not None:
            self.player.jump(max(self.timeline.start_ns, min(self.timeline.end_ns, kept.playhead)))

    # -- the window's side ---------------------------------------------------------------------------------------------

    def request(self, action: Callable[[], object]) -> None:
        """Have `action` called by the program: whatever changes the player."""
        self._requests.append(action)
        self._wanted.set()

    def load(self, path: str) -> None:
        """Open a bag and add it to the timeline."""
        self._load_next(path)

    def _load_next(self, path: str, problem: str = "") -> None:
        """`problem` is told when it is open."""
        self._to_load.append((path, problem))
        self._loads.set()

    def see(self, left_ns: int, right_ns: int) -> None:
        """This part of the timeline is in sight: single messages are looked up, where they can be told apart."""
        self._in_sight = (left_ns, right_ns)
        self._looks.set()

    def toggle_publishing(self, topic: str) -> None:
        """Publish a topic, or stop that."""
        self.request(lambda: self._publish([topic], topic not in self.player.publishing))

    def publish_all(self, on: bool) -> None:
        """Publish all topics, or none."""
        self.request(lambda: self._publish(self.topics, on))

    def _publish(self, topics: Iterable[str], on: bool) -> None:
        self.player.problem = ""
        for topic in topics:
            (self.player.start_publishing if on else self.player.stop_publishing)(topic)

    def shown(self, topic: str) -> ShownMessage | None:
        """The message of a watched topic at the playhead; None if there is none, or it is not read yet."""
        found = self.player.current.get(topic)
        if found is None:
            return None
        message, before = self._shown.get(topic, (None, None))
        if message is found:
            return before
        kind = self.topics.get(topic, "")
        if len(found.data) > MOST_SHOWN:
            after = ShownMessage(kind, found.received_ns, None, f"{len(found.data)} bytes")
        else:
            try:
                after = ShownMessage(kind, found.received_ns, deserialize(found.data, get_interface(kind)))
            except (DeserializationError, UnknownInterfaceError, ValueError, LookupError) as error:
                after = ShownMessage(kind, found.received_ns, None, str(error))
        self._shown[topic] = (found, after)
        return after

    def watch(self, *topics: str) -> None:
        """Read the messages of these topics at the playhead, for `shown`."""
        self.request(lambda: self.player.watch(topics))

    def record(self, path: str, topics: Sequence[str] | None) -> None:
        """Record topics (None: all) to a new bag, in place of what is open."""
        self.request(lambda: self._record(path, topics))

    def stop_recording(self) -> None:
        """Finish the recording, and open it."""
        self.request(lambda: self._finish())

    def export(self, path: str, topics: Sequence[str]) -> None:
        """Copy the messages of topics in the selected region, or all of them, to a new bag."""
        self.request(lambda: self._export(path, topics))

    @property
    def is_busy(self) -> bool:
        """Whether a bag is loaded or copied."""
        return self.loading or self.exporting is not None

    def cancel(self) -> None:
        """Stop copying, or loading: then the bag is shown as far as it is read."""
        self._cancelled = True

    def graph_topics(self) -> list[str]:
        """The topics that can be recorded, sorted; hidden ones are left out."""
        names = sorted(name for name, _ in self._node.get_topic_names_and_types())
        return [name for name in names if not any(part.startswith("_") for part in name.split("/"))]

    def nearby(self) -> list[str]:
        """The bags in the working folder."""
        try:
            folders = sorted(entry.name for entry in self._session.cwd.iterdir() if entry.is_dir())
        except OSError:
            return []
        return [name for name in folders if is_bag(self._session.cwd / name)]

    def thumbnail(self, topic: str, time_ns: int, columns: int, rows: int) -> Picture | None:
        """The image of a topic at a time in at most so many pixels; None while it isn't there: then it is looked for."""
        key = (topic, time_ns, columns, rows)
        found = self._pictures.get(key)
        if found is None and key not in self._pictures and key not in self._missing:
            self._missing.append(key)
            self._wanted_pictures.set()
        return found

    # -- the program's side --------------------------------------------------------------------------------------------

    @property
    def work(self) -> Sequence[Callable[[], Coroutine[Any, Any, None]]]:
        """What goes on beside `serve`, each for ever."""
        own = (self.serve_loads, self.serve_looks, self.serve_recording, self.serve_export, self.serve_pictures)
        return (*own, self.player.run)

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
                await self._load(*self._to_load.popleft())
            if self._resumed.bags and self.bags:
                self._look_as_before()

    async def serve_looks(self) -> None:
        """Look up the messages in sight, for ever."""
        while True:
            await self._session.wait(self._looks)
            self._looks.clear()
            if self._in_sight is not None:
                await self._look(*self._in_sight)

    def tell(self, text: str | Note, *, failed: bool = False) -> None:
        """Show a line of text."""
        self.status, self.failed = text, failed
        self._version += 1

    def dismiss(self) -> None:
        """Show no longer what went wrong, or has been done."""
        if not self.is_busy and (self.status or self.player.problem):
            self.player.problem = ""
            self.tell("")

    async def _load(self, name: str, problem: str) -> None:
        path = self._session.path(name)
        blocks = self.timeline.blocks
        self.tell(f"Loading '{name}' ...")
        self.loading, self._cancelled = True, False
        try:
            bag = await in_thread(lambda: open_bag(path))
            self._add(bag)
            await in_thread(lambda: index_bag(bag, self.timeline, lambda: self._is_closed(bag)))
            self._began()
            rates = await in_thread(lambda: {topic: self.timeline.rate(topic) for topic in bag.topics})
            self.rates = {**self.rates, **rates}
            kinds = {
                "cancelled": self._cancelled, "cut": not bag.is_complete, "empty": self.timeline.blocks == blocks
            }  # fmt: skip
            note = next((Note(kind, name) for kind, holds in kinds.items() if holds), "")
            self.tell(problem or note, failed=bool(problem))
        except (RuntimeError, OSError) as error:
            if not self.timeline.blocks:
                self._start_anew()  # nothing of it can be shown
            self.tell(f"Loading '{name}' failed due to: {reason(error)}", failed=True)
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

    def _is_closed(self, bag: OpenBag) -> bool:
        """Asked between two blocks, in the thread: topics that metadata.yaml doesn't name are shown as soon as they come."""
        if not self._closed and bag.topics.keys() - self.topics.keys():
            self.request(self._refresh)
            self.request(self._began)
        return self._closed or self._cancelled

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
            self.tell(reason(error), failed=True)

    # -- recording and exporting ---------------------------------------------------------------------------------------

    def _start_anew(self) -> None:
        """Close all bags."""
        for bag in self.bags:
            bag.close()
        self._version += self.timeline.version + self.player.version
        self.timeline, self.bags, self.rates, self._has_begun = Timeline(), (), {}, False
        self.view = None
        self._pictures.clear()
        self._shown.clear()
        self.player.forget(self.timeline)
        self._refresh()

    def _record(self, name: str, topics: Sequence[str] | None) -> None:
        if self.recorder is not None or self.loading or self.exporting is not None:
            what = self.exporting_to or self.status or "Recording"
            self.tell(f"Background operation already running: {what}", failed=True)
            return
        self._start_anew()
        self._resumed = Kept()
        path = self._session.path(name)
        self._node.get_logger().get_child("rqt_bag.BagWidget").info(f"Recording to {name}.")
        try:
            self.recorder = Recorder(self._node, path, topics, self.timeline)
        except (RuntimeError, OSError) as error:
            self.tell(f"Error opening bag for recording [{name}]: {reason(error)}", failed=True)
            return
        self.tell("")
        self._records.set()

    async def serve_recording(self) -> None:
        """Look after the recording, for ever."""
        while True:
            await self._session.wait(self._records)
            self._records.clear()
            async for _ in self._session.every(POLL_SECONDS):
                recorder = self.recorder
                if recorder is None:
                    break
                recorder.poll()
                self.topics = dict(sorted(recorder.types.items()))
                if self.timeline.end_ns is not None:
                    self.player.playhead.jump(self.timeline.end_ns)
                self._version += 1
                if recorder.failure is not None:
                    self._finish()

    def _finish(self) -> None:
        recorder, self.recorder = self.recorder, None
        if recorder is None:
            return
        recorder.stop()
        self._start_anew()
        problem = "" if recorder.failure is None else f"Error writing to bag: {reason(recorder.failure)}"
        self._load_next(str(recorder.path), problem)

    def _export(self, name: str, topics: Sequence[str]) -> None:
        if self.exporting is not None or self.recorder is not None:
            what = self.exporting_to or "Recording"
            self.tell(f"Background operation already running: {what}", failed=True)
            return
        self.exporting, self.exporting_to, self._cancelled = 0, f'Copying messages to "{name}"', False
        self._exports = (name, topics, self.player.play_region)
        self._wanted_export.set()

    async def serve_export(self) -> None:
        """Copy parts of bags, for ever."""
        while True:
            await self._session.wait(self._wanted_export)
            self._wanted_export.clear()
            if self._exports is not None:
                await self._copy(*self._exports)
                self.exporting, self.exporting_to = None, ""

    async def _copy(self, name: str, topics: Sequence[str], region: tuple[int, int]) -> None:
        path = self._session.path(name)
        timeline, bags = self.timeline, self.bags

        def cancelled() -> bool:
            return self._cancelled or self._closed

        try:
            count = await in_thread(lambda: export(timeline, bags, path, topics, *region, self._progress, cancelled))
        except ExportError as error:
            self.tell(reason(error), failed=True)
        else:
            self.tell(f'{"Cancelled: " if self._cancelled else ""}{count} messages in "{name}"')

    def _progress(self, percent: int) -> None:
        if percent != self.exporting:
            self.exporting = percent
            self._version += 1

    # -- pictures ------------------------------------------------------------------------------------------------------

    async def serve_pictures(self) -> None:
        """Read the images that the window misses, the last one asked for first, for ever."""
        while True:
            await self._session.wait(self._wanted_pictures)
            self._wanted_pictures.clear()
            while self._missing:
                key = self._missing.pop()
                found = await in_thread(lambda key=key: self._picture(*key))  # type: ignore[misc]
                self._pictures[key] = found
                while len(self._pictures) > MOST_PICTURES:
                    self._pictures.popitem(last=False)
                self._version += 1

    def _picture(self, topic: str, time_ns: int, columns: int, rows: int) -> Picture | None:
        try:
            for found in self.timeline.newest(topic, time_ns):
                return picture(deserialize(found.read().data, get_interface(IMAGE)), columns, rows)
        except (NoPicture, DeserializationError, RuntimeError, OSError) as error:
            self.tell(f"Error loading image on topic {topic}: {reason(error)}", failed=True)
        return None

    def close(self) -> None:
        """Stop publishing, and close the files."""
        self._closed = True
        if self.recorder is not None:
            self.recorder.stop()
        self.player.close()
        for bag in self.bags:
            bag.close()
