"""The endpoints of nodes: publishers, subscriptions, service servers and clients.

An endpoint with `origin` set represents one in another process; the link (`day6_core.link`) creates and removes those. Delivery
needs no lock: the graph replaces the tuples of matched endpoints as a whole, and queues are `deque`s. Only a publisher that keeps
messages for late joiners uses one, so that each message reaches a late joiner once and in order.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from enum import Enum
from itertools import count
from time import monotonic_ns
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.graph.events import AliveWatch, DeadlineWatch, LeaseWatch, Watch
from day6_core.graph.events import EventKind as EventKind
from day6_core.graph.events import EventStatus as EventStatus
from day6_core.graph.open_policies import is_open, resolved_for_publisher, resolved_for_subscription
from day6_core.graph.qos import Durability, Liveliness, QoS, is_finite

if TYPE_CHECKING:
    from day6_core.graph.node import Node

Copier = Callable[[Any], Any]

COUNTED_NS = 1_000_000_000
"""Who reads how many messages were delivered reads it again within this time, as long as it is interested."""


class EndpointKind(str, Enum):
    """The four kinds of endpoint; the values are the entity codes of rmw_zenoh's liveliness tokens."""

    PUBLISHER = "MP"
    SUBSCRIPTION = "MS"
    SERVICE = "SS"
    CLIENT = "SC"


class MessageInfo(NamedTuple):
    """The metadata of a received message (rmw_message_info_t). Times are epoch nanoseconds."""

    source_timestamp: int
    received_timestamp: int
    publication_sequence_number: int
    reception_sequence_number: int
    publisher_gid: bytes
    from_intra_process: bool


class RequestId(NamedTuple):
    """Identifies a service request: its client's GID (16 bytes) and its sequence number (rmw_request_id_t)."""

    client_gid: bytes
    sequence_number: int


class Endpoint:
    """The common part of all four kinds.

    `topic` is the full topic or service name, `type_name` like `std_msgs/msg/String`, `type_hash` like `RIHS01_…`.
    `on_event(endpoint, kind)` is called from any thread after an event's counters have changed.
    """

    kind: EndpointKind

    def __init__(self, node: Node, topic: str, type_name: str, type_hash: str, qos: QoS, gid: bytes | None) -> None:
        self.node = node
        self.topic = topic
        self.type_name = type_name
        self.type_hash = type_hash
        self.qos = qos.resolved()
        self._gid = gid
        self.entity_id = node.graph.next_entity_id()
        self.destroyed = False
        self.events: dict[EventKind, EventStatus] = {kind: EventStatus() for kind in EventKind}
        self.on_event: Callable[[Endpoint, EventKind], None] | None = None
        self.watches: dict[EventKind, Watch] = {}
        """Sources of events that time alone can raise, for the few endpoints whose QoS has a deadline or a lease."""

    @property
    def gid(self) -> bytes:
        """The 16 bytes that identify this endpoint among all processes (created on first access)."""
        if self._gid is None:
            return self.node.graph.assign_gid(self)
        return self._gid

    @property
    def origin(self) -> object | None:
        """The link's marker of the process this endpoint belongs to; None for this process."""
        return self.node.origin

    def status(self, kind: EventKind) -> EventStatus:
        """Return the present counters of one kind of event."""
        watch = self.watches.get(kind)
        if watch is not None:
            watch.settle(self.node.graph.now_ns())
        return self.events[kind]

    def due(self, kind: EventKind) -> int | None:
        """Return when time alone will raise an event of that kind (ns of the graph's time), None if it will not."""
        watch = self.watches.get(kind)
        return None if watch is None or self.destroyed else watch.due

    def take_event(self, kind: EventKind) -> EventStatus:
        """Return the counters of one kind of event and reset their changes."""
        return self.status(kind).take()

    def _notify(self, kind: EventKind) -> None:
        if self.on_event is not None:
            self.on_event(self, kind)

    def destroy(self) -> None:
        """Remove the endpoint from the graph; a second call does nothing."""
        self.node.graph.remove_endpoint(self)


def _seen(endpoints: Sequence[Endpoint]) -> int:
    return sum(not endpoint.node.is_observer for endpoint in endpoints)


class Publisher(Endpoint):
    """Sends messages of one type to a topic.

    `matched` are the matching subscriptions of this process, `remote_matched` those of others; both include observers', which
    count nowhere. `copy` returns an independent
    copy of a message for one subscription.
    """

    kind = EndpointKind.PUBLISHER

    def __init__(
        self, node: Node, topic: str, type_name: str, type_hash: str, qos: QoS, gid: bytes | None, copy: Copier
    ) -> None:
        if is_open(qos):
            qos = resolved_for_publisher(
                qos, [each.qos for each in node.graph.endpoints(EndpointKind.SUBSCRIPTION, topic=topic)]
            )
        super().__init__(node, topic, type_name, type_hash, qos, gid)
        self.copy = copy
        self.matched: tuple[Subscription, ...] = ()
        self.remote_matched: tuple[Subscription, ...] = ()
        self._delivered = 0
        self._counted_ns: int | None = None
        """When `delivered` was read last (ns, monotonic)."""
        self._numbers = count(1)
        latched = self.qos.durability == Durability.TRANSIENT_LOCAL
        self.cache: deque[tuple[Any, int, int]] | None = deque(maxlen=self.qos.capacity) if latched else None
        self.keep: Copier = copy
        """Turns a message into what the cache holds; `copy` turns that into a message again."""
        self._joining = threading.RLock()
        """Held while a message is kept, or a late joiner gets what was kept; not while others get a message."""
        self._deadline: DeadlineWatch | None = None
        self._lease: LeaseWatch | None = None
        if is_finite(self.qos.deadline):
            self._deadline = DeadlineWatch(self.qos.deadline, self.events[EventKind.DEADLINE_MISSED])
            self.watches[EventKind.DEADLINE_MISSED] = self._deadline
        if self.qos.liveliness == Liveliness.MANUAL_BY_TOPIC and is_finite(self.qos.liveliness_lease_duration):
            self._lease = LeaseWatch(self.qos.liveliness_lease_duration, self.events[EventKind.LIVELINESS_LOST])
            self.watches[EventKind.LIVELINESS_LOST] = self._lease

    @property
    def subscription_count(self) -> int:
        """Number of matched subscriptions, here and elsewhere."""
        return _seen(self.matched) + _seen(self.remote_matched)

    @property
    def delivered(self) -> int:
        """Messages that passed through this process; shown as pulses in rqt_graph."""
        self._counted_ns = monotonic_ns()
        return self._delivered

    @property
    def is_attended(self) -> bool:
        """Whether the moment of a message matters to anybody: a subscription, a late joiner, a watch, somebody who counts."""
        if self.matched or self.remote_matched or self.cache is not None or self.watches:
            return True
        return self._counted_ns is not None and monotonic_ns() - self._counted_ns < COUNTED_NS

    def publish_unheard(self, messages: int) -> None:
        """Publish so many messages that went to nobody: they are numbered and counted, and that is all."""
        for _ in range(messages):
            next(self._numbers)
        self._delivered += messages

    def count_delivery(self) -> None:
        """Count a message of a remote publisher (called by the link)."""
        self._delivered += 1

    def publish(self, message: Any) -> None:
        """Deliver a copy of `message` to every matched subscription; if transient local, keep one for late joiners."""
        # As in `is_attended`, written out: no other line runs as often.
        if not (self.matched or self.remote_matched or self.watches) and self.cache is None:
            next(self._numbers)
            self._delivered += 1
            return
        graph = self.node.graph
        source_timestamp = graph.now_ns()
        number = next(self._numbers)
        if self.watches:
            self._note_publication(source_timestamp)
        self.deliver(message, source_timestamp, number)
        if graph.transport is not None and (self.remote_matched or self.cache is not None):
            graph.transport.publish(self, message, source_timestamp, number)

    def deliver(self, message: Any, source_timestamp: int, number: int) -> None:
        """Deliver copies to the subscriptions of this process (called by the link for a remote publisher)."""
        self._delivered += 1
        copy = self.copy
        if self.cache is None:
            matched = self.matched
        else:
            kept = self.keep(message), source_timestamp, number
            with self._joining:
                self.cache.append(kept)
                matched = self.matched
        if matched:
            now = self.node.graph.now_ns()
            for subscription in matched:
                own = copy(message) if subscription.copies else message
                subscription.receive((own, source_timestamp, number, self, now))

    def match(self, subscription: Subscription) -> None:
        """Deliver to a subscription of this process from now on, first what was kept for a late joiner (called by the graph)."""
        if self.cache is None or subscription.qos.durability != Durability.TRANSIENT_LOCAL:
            self.matched = (*self.matched, subscription)
            return
        with self._joining:
            self.matched = (*self.matched, subscription)
            now = self.node.graph.now_ns()
            for message, source_timestamp, number in self.kept()[-subscription.qos.capacity :]:
                subscription.receive((self.copy(message), source_timestamp, number, self, now))

    def kept(self) -> list[tuple[Any, int, int]]:
        """Return the messages for late joiners: (message, source timestamp in ns, number), without expired ones."""
        return [each for each in list(self.cache or ()) if not self.expired(each[1])]

    def expired(self, source_timestamp: int) -> bool:
        """Return whether a message with that source timestamp (ns) has outlived the publisher's lifespan."""
        lifespan = self.qos.lifespan
        return is_finite(lifespan) and self.node.graph.now_ns() - source_timestamp > lifespan

    def assert_liveliness(self) -> None:
        """Assert liveliness without a message."""
        now = self.node.graph.now_ns()
        if self._lease is not None and self._lease.asserted(now):
            self._notify(EventKind.LIVELINESS_LOST)
        for subscription in self.matched:
            if subscription.note_alive(self, now):
                subscription._notify(EventKind.LIVELINESS_CHANGED)

    def _note_publication(self, now: int) -> None:
        if self._deadline is not None and self._deadline.message(now):
            self._notify(EventKind.DEADLINE_MISSED)
        if self._lease is not None and self._lease.asserted(now):
            self._notify(EventKind.LIVELINESS_LOST)


Sample = tuple[Any, int, int, Publisher, int]
"""message, source timestamp in ns, publication sequence number, publisher, time of arrival in ns"""


class Subscription(Endpoint):
    """Receives messages of one type from a topic into a queue of `qos.capacity`; a full queue drops its oldest message.

    `on_ready(subscription)` is called, from the publishing thread, for every message that arrives.
    """

    kind = EndpointKind.SUBSCRIPTION

    def __init__(self, node: Node, topic: str, type_name: str, type_hash: str, qos: QoS, gid: bytes | None) -> None:
        if is_open(qos):
            qos = resolved_for_subscription(
                qos, [each.qos for each in node.graph.endpoints(EndpointKind.PUBLISHER, topic=topic)]
            )
        super().__init__(node, topic, type_name, type_hash, qos, gid)
        self.queue: deque[Sample] = deque(maxlen=self.qos.capacity)
        self.matched: tuple[Publisher, ...] = ()
        self.on_ready: Callable[[Subscription], None] | None = None
        self.on_message: Callable[[Any], object] | None = None
        """Takes every message at once, on the publishing thread; then none is queued."""
        self.dropped = 0
        self.accepts: Callable[[Any], bool] | None = None
        """The content filter: messages for which it returns false are not received."""
        self.copies = True
        """Whether it is given a copy of its own of each message of this process; without, it may only read them."""
        self.takes_bytes = False
        """Whether it is given the messages of other processes as they come, as CDR bytes; those of this one never are."""
        self._received = 0
        self._lifespan = self.qos.lifespan if is_finite(self.qos.lifespan) else 0
        self._deadline: DeadlineWatch | None = None
        self._alive: AliveWatch | None = None
        if is_finite(self.qos.deadline):
            self._deadline = DeadlineWatch(self.qos.deadline, self.events[EventKind.DEADLINE_MISSED])
            self.watches[EventKind.DEADLINE_MISSED] = self._deadline
        if is_finite(self.qos.liveliness_lease_duration):
            self._alive = AliveWatch(self.qos.liveliness_lease_duration, self.events[EventKind.LIVELINESS_CHANGED])
            self.watches[EventKind.LIVELINESS_CHANGED] = self._alive
        self._accepts_all = not self.watches

    @property
    def received(self) -> int:
        """Number of messages that were taken so far."""
        return self._received

    @property
    def publisher_count(self) -> int:
        """Number of matched publishers, here and elsewhere."""
        return _seen(self.matched)

    def receive(self, sample: Sample) -> None:
        """Queue one sample (called by publishers)."""
        if not self._accepts_all and not self._admit(sample):
            return
        if self.on_message is not None:
            self._received += 1
            self.on_message(sample[0])
            return
        queue = self.queue
        if len(queue) == queue.maxlen:
            self.dropped += 1
        queue.append(sample)
        on_ready = self.on_ready
        if on_ready is not None:
            on_ready(self)

    def filter_by(self, accepts: Callable[[Any], bool] | None) -> None:
        """Receive only messages for which `accepts(message)` is true; None removes the filter."""
        self.accepts = accepts
        self._accepts_all = accepts is None and not self.watches

    def _admit(self, sample: Sample) -> bool:
        """Apply the filter and the watches to a sample; return whether it is received."""
        now = self.node.graph.now_ns()
        if sample[3].qos.liveliness == Liveliness.MANUAL_BY_TOPIC and self.note_alive(sample[3], now):
            self._notify(EventKind.LIVELINESS_CHANGED)
        if self.accepts is not None and not self.accepts(sample[0]):
            return False
        if self._deadline is not None and self._deadline.message(now):
            self._notify(EventKind.DEADLINE_MISSED)
        return True

    def note_alive(self, publisher: Publisher, now: int) -> bool:
        """Note that a publisher has asserted its liveliness; return whether that changed anything."""
        for_ever = publisher.qos.liveliness != Liveliness.MANUAL_BY_TOPIC
        return self._alive is not None and self._alive.asserted(publisher, now, for_ever=for_ever)

    def note_gone(self, publisher: Publisher) -> bool:
        """Note that a publisher is gone; return whether that changed anything."""
        return self._alive is not None and self._alive.gone(publisher, self.node.graph.now_ns())

    def take(self) -> Sample | None:
        """Return the oldest queued sample, or None. Samples older than the subscription's lifespan are skipped.

        The publisher's lifespan applies only to the messages it keeps for late joiners, as in Fast DDS.
        """
        while True:
            try:
                sample = self.queue.popleft()
            except IndexError:
                return None
            if self._lifespan and self.node.graph.now_ns() - sample[1] > self._lifespan:
                continue
            self._received += 1
            return sample

    def message_info(self, sample: Sample) -> MessageInfo:
        """Return the metadata of the sample that `take` has just returned."""
        _, source_timestamp, number, publisher, received = sample
        return MessageInfo(source_timestamp, received, number, self._received, publisher.gid, publisher.origin is None)


class Service(Endpoint):
    """A service server. `copy_response` returns an independent copy of a response for a client."""

    kind = EndpointKind.SERVICE

    def __init__(
        self, node: Node, topic: str, type_name: str, type_hash: str, qos: QoS, gid: bytes | None, copy_response: Copier
    ) -> None:
        super().__init__(node, topic, type_name, type_hash, qos, gid)
        self.copy_response = copy_response
        self.queue: deque[tuple[Any, RequestId]] = deque(maxlen=self.qos.capacity)
        self.matched: tuple[Client, ...] = ()
        self.on_ready: Callable[[Service], None] | None = None

    def receive(self, request: Any, request_id: RequestId) -> None:
        """Queue one request (called by clients and the link)."""
        self.queue.append((request, request_id))
        on_ready = self.on_ready
        if on_ready is not None:
            on_ready(self)

    def take(self) -> tuple[Any, RequestId] | None:
        """Return the oldest request and its id, or None."""
        try:
            return self.queue.popleft()
        except IndexError:
            return None

    def send_response(self, request_id: RequestId, response: Any) -> None:
        """Send a response to the client of a request; does nothing if that client is gone."""
        for client in self.matched:
            if client.gid == request_id.client_gid:
                if client.origin is None:
                    client.receive(self.copy_response(response), request_id.sequence_number)
                    return
                break
        transport = self.node.graph.transport
        if transport is not None:
            transport.send_response(self, request_id, response)


class Client(Endpoint):
    """A service client. `copy_request` returns an independent copy of a request for a server."""

    kind = EndpointKind.CLIENT

    def __init__(
        self, node: Node, topic: str, type_name: str, type_hash: str, qos: QoS, gid: bytes | None, copy_request: Copier
    ) -> None:
        super().__init__(node, topic, type_name, type_hash, qos, gid)
        self.copy_request = copy_request
        self.queue: deque[tuple[Any, int]] = deque(maxlen=self.qos.capacity)
        self.matched: tuple[Service, ...] = ()
        self.on_ready: Callable[[Client], None] | None = None
        self._numbers = count(1)

    def service_is_ready(self) -> bool:
        """Return whether at least one server of the service exists."""
        return bool(self.matched)

    def send_request(self, request: Any) -> int:
        """Send a copy of `request` to every server and return its sequence number; `take` returns the responses."""
        number = next(self._numbers)
        remote = False
        for service in self.matched:
            if service.origin is None:
                service.receive(self.copy_request(request), RequestId(self.gid, number))
            else:
                remote = True
        transport = self.node.graph.transport
        if remote and transport is not None:
            transport.send_request(self, request, number)
        return number

    def receive(self, response: Any, number: int) -> None:
        """Queue one response (called by services and the link)."""
        self.queue.append((response, number))
        on_ready = self.on_ready
        if on_ready is not None:
            on_ready(self)

    def take(self) -> tuple[Any, int] | None:
        """Return the oldest response and the number of its request, or None."""
        try:
            return self.queue.popleft()
        except IndexError:
            return None
