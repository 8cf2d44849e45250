"""Messages between local publishers and subscriptions and Zenoh."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.graph.endpoints import Publisher, Subscription
from day6_core.graph.qos import Durability, Reliability
from day6_core.interfaces import deserialize, serialize
from day6_core.link.attachment import pack, unpack
from day6_core.link.classes import message_class
from day6_core.link.engine import engine_of, extras_of
from day6_core.link.engine_thread import callback
from day6_core.link.gid import gid_of
from day6_core.link.keys import data_key, endpoint_token
from day6_core.link.limits import Refusals
from day6_core.link.paths import LinkError
from day6_core.link.remote import RemoteGraph

if TYPE_CHECKING:
    import zenoh

Report = Callable[[str, Exception], None]

_LONGEST_ROUTE_WAIT = 2.0
"""Seconds that the first message of a publisher waits for a subscription that was announced."""


class _ZenohPublisher(NamedTuple):
    """A Zenoh publisher, its GID, and the number of the last message it sent when it was opened."""

    publisher: Any
    gid: bytes
    replayed: int

    def put(self, message: Any, source_timestamp: int, number: int) -> None:
        self.publisher.put(serialize(message), attachment=pack(number, source_timestamp, self.gid))


def _wait_for_route(publisher: Publisher, declared: zenoh.Publisher) -> None:
    """Wait for a new Zenoh publisher's route: over a router a subscription's token may arrive before the subscription.

    Within one machine the route is known at once, unless the machine is a slow one.
    """
    deadline = time.monotonic() + _LONGEST_ROUTE_WAIT
    while publisher.remote_matched and not _has_route(declared) and time.monotonic() < deadline:
        time.sleep(0.001)


def _has_route(publisher: zenoh.Publisher) -> bool:
    status: Any = publisher.matching_status  # a MatchingStatus; Zenoh's stub is wrong
    return bool(status.matching)


class Topics:
    """Carries the messages of local publishers out and those of remote publishers in."""

    def __init__(
        self,
        session: zenoh.Session,
        zid: str,
        remote: RemoteGraph,
        report: Report,
        refusals: Refusals,
        *,
        never_wait: bool = False,
    ) -> None:
        self._session: zenoh.Session | None = session
        self._zid = zid
        self._remote = remote
        self._report = report
        self._refusals = refusals
        self._never_wait = never_wait
        # Reentrant: a garbage collection may withdraw an endpoint in the middle of anything.
        self._lock = threading.RLock()
        self._publishers: dict[Publisher, _ZenohPublisher] = {}
        self._own_gids: set[bytes] = set()
        """This process's publishers: a late joiner's query for kept messages reaches their caches too."""

    def publish(self, publisher: Publisher, message: Any, source_timestamp: int, number: int) -> None:
        """Send one message, declaring the Zenoh publisher if it is the first."""
        declared = self._publishers.get(publisher)
        if declared is None:
            declared = self.open(publisher)
            if publisher.cache is None and not self._never_wait:
                _wait_for_route(publisher, declared.publisher)
        if number > declared.replayed:
            declared.put(message, source_timestamp, number)

    def open(self, publisher: Publisher) -> _ZenohPublisher:
        """Declare the Zenoh publisher; the messages a transient-local one has kept go into Zenoh's cache."""
        with self._lock:
            declared = self._publishers.get(publisher)
            if declared is None:
                gid = gid_of(endpoint_token(publisher, self._zid))
                self._own_gids.add(gid)
                declared = _ZenohPublisher(self._declare(publisher), gid, 0)
                for message, source_timestamp, number in publisher.kept():
                    # Through `copy`: a publisher may keep something smaller than messages (rclpy's /rosout does).
                    declared.put(publisher.copy(message), source_timestamp, number)
                    declared = declared._replace(replayed=number)
                self._publishers[publisher] = declared
            return declared

    def subscribe(self, subscription: Subscription) -> Any:
        """Receive for a local subscription from now on, until `undeclare()` of the returned subscriber.

        Each subscription has its own Zenoh subscriber, so that every late joiner gets the messages publishers kept, and
        volatile ones do not.
        """
        session = self._open_session()
        engine = engine_of(session)
        handler = engine.handlers.Callback(callback(self._receiver(subscription), often=True), indirect=False)
        if subscription.qos.durability != Durability.TRANSIENT_LOCAL:
            return session.declare_subscriber(data_key(subscription), handler, allowed_origin=engine.Locality.REMOTE)
        ext = extras_of(session)
        return ext.declare_advanced_subscriber(
            session,
            data_key(subscription),
            handler,
            allowed_origin=engine.Locality.REMOTE,
            history=ext.HistoryConfig(detect_late_publishers=True, max_samples=subscription.qos.capacity),
        )

    def withdraw(self, publisher: Publisher) -> None:
        """Undeclare a publisher that was destroyed."""
        with self._lock:
            declared = self._publishers.pop(publisher, None)
        if declared is not None:
            declared.publisher.undeclare()

    def close(self) -> None:
        """Drop the session and every publisher in it."""
        with self._lock:
            self._session = None
            self._publishers.clear()

    def _open_session(self) -> zenoh.Session:
        if self._session is None:
            raise LinkError("the link was closed")
        return self._session

    def _declare(self, publisher: Publisher) -> Any:
        session = self._open_session()
        engine = engine_of(session)
        waits = publisher.qos.reliability == Reliability.RELIABLE and not self._never_wait
        control = engine.CongestionControl.BLOCK if waits else engine.CongestionControl.DROP
        remote = engine.Locality.REMOTE
        if publisher.cache is None:
            return session.declare_publisher(
                data_key(publisher), congestion_control=control, allowed_destination=remote
            )
        ext = extras_of(session)
        return ext.declare_advanced_publisher(
            session,
            data_key(publisher),
            congestion_control=control,
            allowed_destination=remote,
            cache=ext.CacheConfig(max_samples=publisher.qos.capacity),
            publisher_detection=True,
        )

    def _receiver(self, subscription: Subscription) -> Callable[[zenoh.Sample], None]:
        message_type: type | None = None

        def receive(sample: zenoh.Sample) -> None:
            # Runs on Zenoh's thread: nothing here may block, and no exception may escape.
            nonlocal message_type
            try:
                attachment = sample.attachment
                if attachment is None or subscription.destroyed:
                    return
                received = subscription.node.graph.now_ns()
                number, source_timestamp, gid = unpack(attachment.to_bytes())
                if gid in self._own_gids:
                    return
                publisher = self._remote.publisher_for(gid, subscription)
                if publisher is None or (publisher.cache is not None and publisher.expired(source_timestamp)):
                    return
                message: Any = sample.payload.to_bytes()
                if not subscription.takes_bytes or subscription.accepts is not None:
                    if message_type is None:
                        message_type = message_class(subscription.type_name)
                    message = deserialize(message, message_type)
                publisher.count_delivery()
                subscription.receive((message, source_timestamp, number, publisher, received))
            except Exception as error:
                self._refusals.add("messages")
                self._report(f"a message on {subscription.topic} was lost", error)

        return receive
