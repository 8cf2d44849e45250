"""Rules about transforms that a terminal's program asked for in vain: whether that is still so."""

from __future__ import annotations

import re
from collections.abc import Sequence

from day6_core.advice.matching import Sighting
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.outputs import LineOutput

OTHER_LINES = 3
"""As many lines after a complaint show that the program got further."""

OLD_NS = 10_000_000_000
"""A program that still fails would have complained again in this time."""

_STAMP = re.compile(r"\[(\d{9,10}\.\d+)\]")
"""The time of a line of a log."""


def of_extrapolation(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    """Say that a transform was asked for at the wrong time, unless that is over."""
    said = _STAMP.search(seen[-1].line)
    old = said is not None and facts.now_ns - float(said[1]) * 1e9 > OLD_NS
    if _got_further(seen[-1]) or (output.running and old):
        return None
    direction = seen[-1].values["direction"]
    return finding("warning", "extrapolation", line=output.source, direction=direction, then="ros2 topic delay /tf")


def of_frame(output: LineOutput, seen: Sequence[Sighting], facts: Facts) -> Finding | None:
    """Say that a frame is not there, unless that is over."""
    frame = seen[-1].values["frame"]
    if _got_further(seen[-1]) or (output.running and frame.lstrip("/") in facts.frames):
        return None
    return finding("warning", "no_frame", line=output.source, frame=frame, then="ros2 run tf2_tools view_frames")


def _got_further(last: Sighting) -> bool:
    """Whether the program went on after its last complaint: only its beginning came too early."""
    return len(last.rest.rstrip().split("\n")) >= OTHER_LINES
