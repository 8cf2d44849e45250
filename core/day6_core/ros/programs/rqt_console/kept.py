"""What a perspective keeps of the console: whether it is paused, and its filters.

`paused` and `show_highlighted_only` have rqt_console's names. Its filters are in groups of Qt's settings; here they are one list.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from day6_core.ros.programs.rqt_console.filters import KINDS, SIDES, Filter, FilterChoice
from day6_core.ros.programs.rqt_console.model import Console

MOST_FILTERS = 50
"""That are taken from a perspective."""


def kept_settings(console: Console) -> dict[str, Any]:
    """What `take_settings` understands, as values that JSON has."""
    choice = console.choice
    filters = [
        {"side": side, **asdict(each), "levels": sorted(each.levels), "nodes": sorted(each.nodes)}
        for side in SIDES
        for each in getattr(choice, side)
    ]
    return {"paused": console.paused, "show_highlighted_only": choice.only_highlighted, "filters": filters}


def take_settings(console: Console, settings: Mapping[str, Any]) -> None:
    """Take what a perspective has kept; what is wrong in it is left out."""
    console.paused = settings.get("paused") is True
    console.show_highlighted_only(settings.get("show_highlighted_only") is True)
    entries = settings.get("filters")
    if not isinstance(entries, list):
        return
    sides: dict[str, list[Filter]] = {side: [] for side in SIDES}
    for entry in entries[:MOST_FILTERS]:
        if isinstance(entry, dict) and entry.get("side") in sides and entry.get("kind") in KINDS:
            sides[entry["side"]].append(_filter(entry))
    only = console.choice.only_highlighted
    console.choice = FilterChoice(tuple(sides["excludes"]), tuple(sides["highlights"]), only)


def _filter(entry: Mapping[str, Any]) -> Filter:
    def of(name: str, kind: type[Any], default: Any) -> Any:
        value = entry.get(name)
        return value if type(value) is kind else default

    return Filter(
        entry["kind"],
        of("text", str, ""),
        of("is_regex", bool, False),
        frozenset(each for each in of("levels", list, []) if type(each) is int),
        frozenset(each for each in of("nodes", list, []) if isinstance(each, str)),
        of("start_ns", int, 0),
        of("stop_ns", int, None),
        of("enabled", bool, True),
    )
