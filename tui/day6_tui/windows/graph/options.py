"""rqt_graph's controls as keys, with the labels of the real window."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from day6_core.ros.programs.rqt_graph.model.content import GraphOptions, GraphType

DEEPEST = 4
"""Namespace boxes nest up to this; the key then begins again at none."""


class Switch(NamedTuple):
    """A check box: its key, the option it stands for, and the label of the real tool."""

    key: str
    option: str
    label: str


HIDE = (
    Switch("s", "hide_dead_sinks", "Dead sinks"),
    Switch("l", "hide_leaf_topics", "Leaf topics"),
    Switch("d", "hide_debug", "Debug"),
    Switch("f", "hide_tf", "tf"),
    Switch("u", "hide_unreachable", "Unreachable"),
    Switch("p", "hide_params", "Params"),
)
GROUP = (
    Switch("1", "group_actions", "Actions"),
    Switch("2", "group_tf", "tf"),
    Switch("3", "group_images", "Images"),
)
VIEW = (
    Switch("h", "highlight", "Highlight"),
    Switch("v", "fit", "Fit"),
)
NAMESPACES = Switch("n", "namespaces", "Namespaces")
"""No check box but a number: how many levels of namespaces are drawn as boxes."""

SWITCHES = {switch.key: switch for switch in (*HIDE, *GROUP, *VIEW)}


FILTERS = {"node filter": "/", "topic filter": ":"}
"""What hides, but is no check box, and the key that asks for it."""


def key_of(option: str) -> str:
    """The key of what hides, by the label that stands in `Hidden`; '' for none."""
    return next((switch.key for switch in HIDE if switch.label == option), FILTERS.get(option, ""))


def switched(options: GraphOptions, key: str) -> GraphOptions:
    """Return the options after a key of SWITCHES, `t` (next type) or `n` (namespace boxes one deeper)."""
    if key == "t":
        kinds = list(GraphType)
        return replace(options, graph_type=kinds[(kinds.index(options.graph_type) + 1) % len(kinds)])
    if key == "n":
        return replace(options, namespaces=(options.namespaces + 1) % (DEEPEST + 1))
    name = SWITCHES[key].option
    changed: dict[str, bool] = {name: not getattr(options, name)}
    return replace(options, **changed)  # type: ignore[arg-type]


def text_of(switch: Switch, options: GraphOptions) -> tuple[str, bool | None]:
    """The label of a control, and whether its box is ticked; None for the number of namespaces."""
    if switch is NAMESPACES:
        return f"{options.namespaces} {switch.label}", None
    return switch.label, getattr(options, switch.option)
