"""Which endpoints of one name hear each other. Every pair is looked at once, when the second of it appears.

Called by the graph with its lock held. `told` collects the endpoints and events whose callbacks are to be called afterwards.
"""

from __future__ import annotations

from collections.abc import Iterable

from day6_tui.core.graph.endpoints import Client, Endpoint, EventKind, Publisher, Service, Subscription
from day6_tui.core.graph.qos import Liveliness, incompatible_policies

Told = list[tuple[Endpoint, EventKind]]


def connect(endpoint: Endpoint, others: Iterable[Endpoint], told: Told) -> None:
    """Match a new endpoint with those of its name that are there already."""
    for other in others:
        if isinstance(endpoint, Publisher) and isinstance(other, Subscription):
            _pair(endpoint, other, told)
        elif isinstance(endpoint, Subscription) and isinstance(other, Publisher):
            _pair(other, endpoint, told)
        elif isinstance(endpoint, Service) and isinstance(other, Client):
            _serve(endpoint, other)
        elif isinstance(endpoint, Client) and isinstance(other, Service):
            _serve(other, endpoint)


def disconnect(endpoint: Endpoint, told: Told) -> None:
    """Make everybody forget an endpoint that goes, and it everybody."""
    if isinstance(endpoint, Publisher):
        for subscription in (*endpoint.matched, *endpoint.remote_matched):
            subscription.matched = tuple(each for each in subscription.matched if each is not endpoint)
            if subscription.lost(endpoint):
                told.append((subscription, EventKind.LIVELINESS_CHANGED))
            _count(subscription, -1, told)
        endpoint.matched = endpoint.remote_matched = ()
    elif isinstance(endpoint, Subscription):
        for publisher in endpoint.matched:
            publisher.matched = tuple(each for each in publisher.matched if each is not endpoint)
            publisher.remote_matched = tuple(each for each in publisher.remote_matched if each is not endpoint)
            _count(publisher, -1, told)
        endpoint.matched = ()
    elif isinstance(endpoint, (Service, Client)):
        for other in endpoint.matched:
            other.matched = tuple(each for each in other.matched if each is not endpoint)  # type: ignore[assignment]
        endpoint.matched = ()


def _pair(publisher: Publisher, subscription: Subscription, told: Told) -> None:
    if publisher.origin is not None and subscription.origin is not None:
        return
    if publisher.type_name != subscription.type_name:
        # Nobody is told: Fast DDS, whose behaviour this is, never raises the event for another type name.
        return
    policies = incompatible_policies(publisher.qos, subscription.qos)
    if policies:
        for endpoint in (publisher, subscription):
            status = endpoint.events[EventKind.INCOMPATIBLE_QOS]
            status.add()
            status.last_policy_kind = policies[-1]
            told.append((endpoint, EventKind.INCOMPATIBLE_QOS))
        return
    subscription.matched = (*subscription.matched, publisher)
    if subscription.origin is None:
        publisher.matched = (*publisher.matched, subscription)
    else:
        publisher.remote_matched = (*publisher.remote_matched, subscription)
    _count(publisher, 1, told)
    _count(subscription, 1, told)
    if subscription.origin is None:
        # A process shows that its automatic publishers live; inside one process Fast DDS tells nothing.
        far_and_automatic = publisher.origin is not None and publisher.qos.liveliness == Liveliness.AUTOMATIC
        if far_and_automatic and subscription.heard_of(publisher, publisher.node.graph.now_ns()):
            told.append((subscription, EventKind.LIVELINESS_CHANGED))
        publisher.replay(subscription)


def _serve(service: Service, client: Client) -> None:
    if service.type_name == client.type_name:
        service.matched = (*service.matched, client)
        client.matched = (*client.matched, service)


def _count(endpoint: Endpoint, change: int, told: Told) -> None:
    status = endpoint.events[EventKind.MATCHED]
    status.current_count += change
    status.current_count_change += change
    if change > 0:
        status.add()
    told.append((endpoint, EventKind.MATCHED))
