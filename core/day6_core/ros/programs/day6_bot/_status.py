"""The remarks beside the car about what is missing or odd: (id, parameters) for the catalogue, and the English text."""

from __future__ import annotations

import difflib
from collections import Counter
from dataclasses import dataclass

from day6_core.ros.programs.remark import Remark


class CarStatus(Remark):
    """One line beside the car."""


status = CarStatus.of


@dataclass(frozen=True, slots=True)
class JointStateFacts:
    """The facts from which the lines are made. `publishers` are node names and types on `topic`, the joint states."""

    described: bool
    loading: bool
    problem: str
    joints: frozenset[str]
    wheels: int
    missing: tuple[str, ...]
    root: str
    topic: str
    publishers: tuple[tuple[str, str], ...]
    heard_joints: tuple[str, ...]
    rate: float | None
    silent_s: float | None
    rolling: bool = False
    """A wheel turns."""


JOINT_STATE = "sensor_msgs/msg/JointState"
SLOW_HZ = 10.0
SILENT_S = 1.5
NAMED_LINKS = 4


def status_lines(facts: JointStateFacts) -> tuple[CarStatus, ...]:
    """Return the lines, the cause before its effects."""
    if facts.problem:
        return (status("error", "car.bad_description", text=facts.problem),)
    if facts.loading:
        return (status("info", "car.loading"),)
    if not facts.described:
        return (status("warning", "car.waiting_for_description"),)
    lines = [] if facts.wheels else [status("warning", "car.no_wheels")]
    lines += _publisher_lines(facts)
    for joint in facts.heard_joints:
        if joint not in facts.joints:
            lines.append(_unknown_joint(joint, facts.joints))
    lines += _transform_lines(facts)
    if facts.rolling and not lines:
        lines.append(status("info", "car.stays"))
    return tuple(lines)


def _transform_lines(facts: JointStateFacts) -> list[CarStatus]:
    named, more = facts.missing[:NAMED_LINKS], len(facts.missing) - NAMED_LINKS
    lines = [status("error", "car.no_transform", link=link, frame=facts.root) for link in named]
    if more > 0:
        lines.append(status("error", "car.no_transform_more", count=more, frame=facts.root))
    return lines


def _publisher_lines(facts: JointStateFacts) -> list[CarStatus]:
    lines = []
    for kind in sorted({kind for _, kind in facts.publishers if kind != JOINT_STATE}):
        lines.append(status("error", "car.wrong_type", topic=facts.topic, type=kind))
    nodes = sorted(node for node, kind in facts.publishers if kind == JOINT_STATE)
    if not facts.publishers:
        lines.append(status("warning", "car.no_joint_states", topic=facts.topic))
    elif len(nodes) > 1:
        names = ", ".join(f"{name} x{number}" if number > 1 else name for name, number in Counter(nodes).items())
        lines.append(status("warning", "car.many_publishers", topic=facts.topic, count=len(nodes), nodes=names))
    if nodes and facts.silent_s is not None and facts.silent_s >= SILENT_S:
        lines.append(status("warning", "car.silent", topic=facts.topic, seconds=int(facts.silent_s)))
    elif nodes and facts.rate is not None and facts.rate < SLOW_HZ:
        lines.append(status("warning", "car.slow", topic=facts.topic, rate=f"{facts.rate:.1f}"))
    return lines


def _unknown_joint(joint: str, joints: frozenset[str]) -> CarStatus:
    near = nearest_name(joint, sorted(joints))
    if near is None:
        return status("error", "car.unknown_joint", joint=joint)
    return status("error", "car.unknown_joint_near", joint=joint, nearest=near)


def nearest_name(name: str, candidates: list[str]) -> str | None:
    """Return the candidate a person most likely meant: the same words in another order, else the most alike."""
    words = sorted(name.split("_"))
    for candidate in candidates:
        if sorted(candidate.split("_")) == words:
            return candidate
    alike = difflib.get_close_matches(name, candidates, 1, 0.7)
    return alike[0] if alike else None
