"""Publishers that keep messages, and subscribers that ask for them, under the names of `zenoh.ext`."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from day6_core.link.local.declared import Announced, Publisher
    from day6_core.link.local.session import Session
    from day6_core.link.local.vocabulary import Callback


class CacheConfig(NamedTuple):
    """How many messages a publisher keeps."""

    max_samples: int


class HistoryConfig(NamedTuple):
    """How many of them a subscriber wants of each publisher; whoever comes later sends them, too."""

    max_samples: int
    detect_late_publishers: bool = True


def declare_advanced_publisher(
    session: Session, key: str, *, congestion_control: str, cache: CacheConfig, **_: object
) -> Publisher:
    """Declare a publisher that keeps messages."""
    return session.declare_publisher(key, congestion_control=congestion_control, keeps=cache.max_samples)


def declare_advanced_subscriber(
    session: Session, key: str, handler: Callback, *, history: HistoryConfig, **_: object
) -> Announced:
    """Declare a subscriber that is sent what was kept."""
    return session.declare_subscriber(key, handler, wants=history.max_samples)
