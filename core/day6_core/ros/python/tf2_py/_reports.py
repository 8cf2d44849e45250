"""A buffer's content as text: the YAML of the service tf2_frames, and DOT."""

from __future__ import annotations

import json
import re

from tf2_py._cache import Cache, seconds, shown
from tf2_py._tree import FrameTree

_SHORTEST_NS = 100_000
"""The rate of a frame is counted over at least this time, so a static frame has the rate 10000."""


def _rate(cache: Cache) -> float:
    span = max(cache.latest_stamp - cache.oldest_stamp, _SHORTEST_NS)
    return len(cache) * 1e9 / span


_LONGEST_KEY = 1000
"""Characters of a key that YAML recognizes by the colon behind it: 1024 at most (YAML 1.2, 7.4.2)."""

_PLAIN = re.compile(r"[A-Za-z_/][\w/.\-]*", re.ASCII)


def _key(frame: str) -> str:
    """A frame as a key: as it is, or so that YAML reads no other name in it, which the original does not mind."""
    key = frame if _PLAIN.fullmatch(frame) or (frame.isalnum() and not frame.isascii()) else _quoted(frame)
    return key if len(key) < _LONGEST_KEY else f"? {key}\n"


def _quoted(name: str) -> str:
    if name.isprintable():
        return "'" + name.replace("'", "''") + "'"
    return json.dumps(name)  # YAML's double quotes know the same escapes


def frames_as_yaml(tree: FrameTree) -> str:
    """Return one YAML mapping from frames to their state; `[]` if there are no frames."""
    if not tree.frames:
        return "[]"
    parts = []
    for frame, cache in tree.frames.items():
        if cache is None or cache.latest_parent is None:
            continue
        parts.append(
            f"{_key(frame)}: \n"
            f"  parent: {_quoted(cache.latest_parent)}\n"
            f"  broadcaster: {_quoted(tree.authorities.get(frame, 'no recorded authority'))}\n"
            f"  rate: {_rate(cache):.3f}\n"
            f"  most_recent_transform: {shown(cache.latest_stamp)}\n"
            f"  oldest_transform: {shown(cache.oldest_stamp)}\n"
            f"  buffer_length: {seconds(cache.latest_stamp - cache.oldest_stamp):.3f}\n"
        )
    return "".join(parts)


def frames_as_dot(tree: FrameTree, now_ns: int) -> str:
    """Return the tree in graphviz's DOT. `now_ns` is the time of recording; 0 leaves it out."""
    lines = ["digraph G {\n"]
    if not tree.frames:
        lines.append('"no tf data recieved"')
    for frame, cache in tree.frames.items():
        if cache is None or cache.latest_parent is None:
            continue
        age = f"( {seconds(now_ns - cache.latest_stamp):.3f} sec old)" if now_ns else ""
        lines.append(
            f'"{cache.latest_parent}" -> "{frame}"[label="'
            f"Broadcaster: {tree.authorities.get(frame, 'no recorded authority')}\\n"
            f"Average rate: {_rate(cache):.3f} Hz\\n"
            f"Most recent transform: {shown(cache.latest_stamp)} {age}\\n"
            f'Buffer length: {seconds(cache.latest_stamp - cache.oldest_stamp):.3f} sec\\n"];\n'
        )
    legend = ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";\n'
    recorded = f'"Recorded at time: {shown(now_ns)}"[ shape=plaintext ] ;\n ' if now_ns else ""
    for frame, cache in tree.frames.items():
        is_root = bool(now_ns) if cache is None else cache.latest_parent is None
        if is_root:
            lines.append(f'edge [style=invis];\n{legend}{recorded}}}->"{frame}";\n')
    return "".join(lines) + "}"
