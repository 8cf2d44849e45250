"""Matches the endpoints of one topic or service. Every pair is considered once, when its second endpoint appears.

Called by the graph with its lock held. `raised` collects the events whose callbacks must be called afterwards; a node that only
looks on raises none.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeVar

from day6_core.graph.endpoints import Client, Endpoint, EndpointKind, EventKind, Publisher, Service, Subscription
from day6_core.graph.qos import Liveliness, incompatible_policies

RaisedEvents = list[tuple[Endpoint, EventKind]]
"""Events raised by a change, in order: endpoint and kind."""

MATCHES = {
    EndpointKind.PUBLISHER: EndpointKind.SUBSCRIPTION,
    EndpointKind.SUBSCRIPTION: EndpointKind.PUBLISHER,
    EndpointKind.SERVICE: EndpointKind.CLIENT,
    EndpointKind.CLIENT: EndpointKind.SERVICE,
}
"""What a kind of endpoint is matched with: nobody else is looked at, though every node publishes /rosout."""

Member = TypeVar("Member")


def without(members: tuple[Member, ...], gone: Member) -> tuple[Member, ...]:
    """Return the members, which nobody may see change, without one of them; the oldest is found first."""
    place = members.index(gone)
    return members[:place] + members[place + 1 :]


def connect(endpoint: Endpoint, others: Iterable[Endpoint], raised: RaisedEvents) -> None:
    """Match a new endpoint with the existing ones of its name and of the kind in MATCHES."""
    for other in others:
        if isinstance(endpoint, Publisher) and isinstance(other, Subscription):
            _pair(endpoint, other, raised)
        elif isinstance(endpoint, Subscription) and isinstance(other, Publisher):
            _pair(other, endpoint, raised)
        elif isinstance(endpoint, Service) and isinstance(other, Client):
            _serve(endpoint, other)
        elif isinstance(endpoint, Client) and isinstance(other, Service):
            _serve(other, endpoint)


def disconnect(endpoint: Endpoint, raised: RaisedEvents) -> None:
    """Remove an endpoint from the matches of all others, and them from its own."""
    if isinstance(endpoint, Publisher):
        for subscription in (*endpoint.matched, *endpoint.remote_matched):
            subscription.matched = without(subscription.matched, endpoint)
            if _is_watched(endpoint, subscription):
                continue
            if subscription.note_gone(endpoint):
                raised.append((subscription, EventKind.LIVELINESS_CHANGED))
            _count(subscription, -1, raised)
        endpoint.matched = endpoint.remote_matched = ()
    elif isinstance(endpoint, Subscription):
        for publisher in endpoint.matched:
            if endpoint.origin is None:
                publisher.matched = without(publisher.matched, endpoint)
            else:
                publisher.remote_matched = without(publisher.remote_matched, endpoint)
            if not _is_watched(publisher, endpoint):
                _count(publisher, -1, raised)
        endpoint.matched = ()
    elif isinstance(endpoint, Service):
        for client in endpoint.matched:
            client.matched = without(client.matched, endpoint)
        endpoint.matched = ()
    elif isinstance(endpoint, Client):
        for service in endpoint.matched:
            service.matched = without(service.matched, endpoint)
        endpoint.matched = ()


def _pair(publisher: Publisher, subscription: Subscription, raised: RaisedEvents) -> None:
    if publisher.origin is not None and subscription.origin is not None:
        return
    if publisher.type_name != subscription.type_name:
        # No event: like Fast DDS, which never raises INCOMPATIBLE_TYPE for another type name.
        return
    policies = incompatible_policies(publisher.qos, subscription.qos)
    watched = _is_watched(publisher, subscription)
    if policies and watched:
        return
    if policies:
        for endpoint in (publisher, subscription):
            status = endpoint.events[EventKind.INCOMPATIBLE_QOS]
            status.add()
            status.last_policy_kind = policies[-1]
            raised.append((endpoint, EventKind.INCOMPATIBLE_QOS))
        return
    subscription.matched = (*subscription.matched, publisher)
    if not watched:
        _count(publisher, 1, raised)
        _count(subscription, 1, raised)
    if subscription.origin is not None:
        publisher.remote_matched = (*publisher.remote_matched, subscription)
    else:
        # A process asserts the liveliness of its automatic publishers; within one process Fast DDS raises no event.
        far_and_automatic = publisher.origin is not None and publisher.qos.liveliness == Liveliness.AUTOMATIC
        if far_and_automatic and not watched and subscription.note_alive(publisher, publisher.node.graph.now_ns()):
            raised.append((subscription, EventKind.LIVELINESS_CHANGED))
        publisher.match(subscription)


def _is_watched(publisher: Publisher, subscription: Subscription) -> bool:
    """Return whether one of the two belongs to a node that only looks on."""
    return publisher.node.is_observer or subscription.node.is_observer


def _serve(service: Service, client: Client) -> None:
    if service.type_name == client.type_name:
        service.matched = (*service.matched, client)
        client.matched = (*client.matched, service)


def _count(endpoint: Endpoint, change: int, raised: RaisedEvents) -> None:
    status = endpoint.events[EventKind.MATCHED]
    status.add_current(change)
    if change > 0:
        status.add()
    raised.append((endpoint, EventKind.MATCHED))
