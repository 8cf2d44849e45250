"""The tree of frames as the service tf2_frames tells it (tf2_msgs/srv/FrameGraph): read, and as graphs to draw."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from day6_core.ros.programs.rqt_graph.model.shapes import Box, Edge
from day6_core.session.harmless import one_line, quotable


class Frame(NamedTuple):
    """A frame that has a parent. `rate` in Hz, all times in seconds."""

    name: str
    parent: str
    broadcaster: str
    rate: float
    buffer_length: float
    most_recent_transform: float
    oldest_transform: float

    @property
    def label(self) -> tuple[str, ...]:
        """The lines on the edge from its parent, as view_frames.py writes them."""
        return (
            f"Broadcaster: {self.broadcaster}",
            f"Average rate: {self.rate}",
            f"Buffer length: {self.buffer_length}",
            f"Most recent transform: {self.most_recent_transform}",
            f"Oldest transform: {self.oldest_transform}",
        )


def read_frames(text: str) -> tuple[Frame, ...]:
    """Return the frames of a FrameGraph answer, in its order. Raises ValueError with what is wrong."""
    import yaml

    try:
        # Every scalar a string: a frame may be named 1, true or null.
        found = getattr(yaml, "CBaseLoader", yaml.BaseLoader)(text).get_single_data()
        return tuple(_frame_of(name, about) for name, about in (found.items() if found else ()))
    except (yaml.YAMLError, AttributeError, KeyError, TypeError, RecursionError) as error:
        raise ValueError(f"{type(error).__name__}: {error}") from error


def _frame_of(name: str, about: dict[str, str]) -> Frame:
    if not (isinstance(about["parent"], str) and isinstance(about["broadcaster"], str)):
        raise TypeError(f"frame {name}: parent and broadcaster are not names")
    numbers = ("rate", "buffer_length", "most_recent_transform", "oldest_transform")
    return Frame(name, about["parent"], about["broadcaster"], *(float(about[number]) for number in numbers))


def roots(frames: Iterable[Frame]) -> tuple[str, ...]:
    """Return the parents that have no parent themselves, in order; frames in a circle have none."""
    frames = tuple(frames)
    names = {frame.name for frame in frames}
    return tuple(dict.fromkeys(frame.parent for frame in frames if frame.parent not in names))


def as_dot(frames: Iterable[Frame], now: float) -> str:
    """Return the tree in graphviz's language; `now` is when it was recorded (seconds)."""
    frames = tuple(frames)
    if not frames:
        return 'digraph G { "No tf data received" }'
    lines = ["digraph G {"]
    for frame in frames:
        label = "".join(f"{quotable(line)}\\n" for line in frame.label)
        lines.append(f'"{quotable(frame.parent)}" -> "{quotable(frame.name)}"[label=" {label}"];')
    tops = set(roots(frames))
    for root in [frame.parent for frame in frames if frame.parent in tops][-1:]:  # the original knows only the last one
        lines.append("edge [style=invis];")
        lines.append(' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";')
        lines.append(f'"Recorded at time: {now}"[ shape=plaintext ] ;')
        lines.append(f'}}->"{quotable(root)}";')
    return "\n".join([*lines, "}"])


def as_graph(frames: Iterable[Frame], now: float) -> tuple[list[Box], list[Edge]]:
    """Return the same tree for our own layout: what is said of a frame stands on its edge."""
    frames = tuple(frames)
    if not frames:
        return [Box("nothing", ("No tf data received",), "node")], []
    boxes = [Box("legend", (f"Recorded at time: {now}",), "text", "view_frames Result")]
    names = dict.fromkeys([*roots(frames), *(frame.parent for frame in frames), *(frame.name for frame in frames)])
    boxes += [Box(_frame(name), (one_line(name),), "node") for name in names]
    boxes += [Box(_label(frame.name), tuple(map(one_line, frame.label)), "text") for frame in frames]
    edges = []
    for frame in frames:
        edges.append(Edge(_frame(frame.parent), _label(frame.name), "", frame.name))
        edges.append(Edge(_label(frame.name), _frame(frame.name), "", frame.name))
    return boxes, edges


def _frame(name: str) -> str:
    return f"frame {name}"


def _label(name: str) -> str:
    return f"label {name}"
