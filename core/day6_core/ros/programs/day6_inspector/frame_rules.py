"""Rules about transforms that a terminal's program asked for in vain: whether that is still so."""

from __future__ import annotations

import re

from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.outputs import Output, outputs

NO_FRAME = "does not exist"
OTHER_LINES = 3
"""As many lines after a complaint show that the program got further."""

OLD_NS = 10_000_000_000
"""A program that still fails would have complained again in this time."""

_STAMP = re.compile(r"\[(\d{9,10}\.\d+)\]")
"""The time of a line of a log."""


def complains_of_frames(facts: Facts) -> bool:
    """Return whether somebody said that a frame does not exist: then it is worth listening whether that is still so."""
    return any(NO_FRAME in output.text for output in outputs(facts))


def of_extrapolation(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    """Say that a transform was asked for at the wrong time, unless that is over."""
    last = _last(output, match)
    begin = output.text.rfind("\n", 0, last.start()) + 1
    said = _STAMP.search(output.text[begin : last.start()])
    old = said is not None and facts.now_ns - float(said[1]) * 1e9 > OLD_NS
    if _got_further(output, last) or (output.running and old):
        return None
    then = "ros2 topic delay /tf"
    return finding("warning", "extrapolation", line=output.source, direction=last[1], then=then)


def of_frame(output: Output, match: re.Match[str], facts: Facts) -> Finding | None:
    """Say that a frame is not there, unless that is over."""
    last = _last(output, match)
    if _got_further(output, last) or (output.running and last[1].lstrip("/") in facts.frames):
        return None
    return finding("warning", "no_frame", line=output.source, frame=last[1], then="ros2 run tf2_tools view_frames")


def _last(output: Output, match: re.Match[str]) -> re.Match[str]:
    *_, last = re.finditer(match.re, output.text)
    return last


def _got_further(output: Output, last: re.Match[str]) -> bool:
    """Whether the program went on after its last complaint: only its beginning came too early."""
    return len(output.text[last.end() :].rstrip().split("\n")) > OTHER_LINES
