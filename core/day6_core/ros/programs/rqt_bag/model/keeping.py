"""What a perspective keeps of rqt_bag. The real one keeps nothing (rqt_bag/bag.py: save_settings), so the names are ours."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from day6_core.ros.programs.rqt_bag.model.view import CLOSEST_NS, FARTHEST_NS, TimeSpan


class Kept(NamedTuple):
    """The open bags and how they were looked at; times are nanoseconds since 1970."""

    bags: tuple[str, ...] = ()
    """Paths from the root on."""
    publishing: tuple[str, ...] = ()
    playhead: int | None = None
    region: tuple[int, int] | None = None
    view: TimeSpan | None = None
    thumbnails: bool = False

    def settings(self) -> dict[str, Any]:
        """As values that JSON has."""
        return {
            "bags": [*self.bags],
            "publishing": [*self.publishing],
            "playhead": self.playhead,
            "region": None if self.region is None else [*self.region],
            "view": None if self.view is None else [*self.view],
            "thumbnails": self.thumbnails,
        }


def read_kept(settings: Mapping[str, Any]) -> Kept:
    """What `Kept.settings` returned, out of a file: what has another shape counts as not kept."""
    playhead, view = settings.get("playhead"), _span(settings.get("view"))
    return Kept(
        _words(settings.get("bags")),
        _words(settings.get("publishing")),
        playhead if _is_time(playhead) else None,
        _span(settings.get("region")),
        TimeSpan(*view) if view is not None and CLOSEST_NS <= view[1] - view[0] <= FARTHEST_NS else None,
        settings.get("thumbnails") is True,
    )


def _words(value: object) -> tuple[str, ...]:
    return tuple(each for each in value if isinstance(each, str) and each) if isinstance(value, list) else ()


def _is_time(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**63


def _span(value: object) -> tuple[int, int] | None:
    if isinstance(value, list) and len(value) == 2 and all(map(_is_time, value)) and value[0] <= value[1]:
        return value[0], value[1]
    return None
