"""Rules about what is sent: values, frames, stamps, transforms, joints."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import timedelta

from day6_core.facts.names import nearest
from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.hearing import CLOCK, JOINT_STATE, TRAJECTORY, Heard
from day6_core.ros.programs.day6_inspector.samples import TRANSFORMS
from day6_core.ros.programs.day6_inspector.sight import looks_at

PLACED = (
    "sensor_msgs/msg/LaserScan",
    "sensor_msgs/msg/PointCloud2",
    "nav_msgs/msg/Odometry",
)
"""Types that are of little use where their frame is unknown. A map's may be the root of everything, without any transform."""

BROKEN = ("not_finite", "data_size", "map_resolution")
"""What makes a message useless as a whole."""

FAR = 60.0
"""Seconds: computers' clocks and slow programs differ by less."""

LONG_AGO = 100_000_000.0
"""1973: a stamp before it counts from the start of something else than 1970."""

PLAYER = "rosbag2_player"
"""The node that repeats what was said once: its stamps are old."""

BEYOND = 0.02
"""Part of a joint's range by which it may be beyond its limits."""


@looks_at("messages")
def of_messages(facts: Facts) -> Iterator[Finding]:
    """Yield what is wrong in messages, whatever else is known."""
    for heard in facts.heard:
        for odd in {odd.key: odd for odd in reversed(heard.odd)}.values():  # of each kind the first is enough
            level = "error" if odd.key in BROKEN else "warning"
            if odd.key == "not_finite" and _may_be_endless(heard, odd.parameters):
                level = "info"
            yield finding(level, odd.key, topic=heard.topic, node=heard.node, **dict(odd.parameters), then=_echo(heard))


def _may_be_endless(heard: Heard, parameters: tuple[tuple[str, str], ...]) -> bool:
    """Whether it is a bare number that says by infinity that there is nothing near, as ranges do (REP 117)."""
    return heard.type.startswith("std_msgs/msg/Float") and dict(parameters)["value"].endswith("inf")


def _echo(heard: Heard) -> str:
    return f"ros2 topic echo {heard.topic} --once"


@looks_at("messages", "frames")
def of_frames(facts: Facts) -> Iterator[Finding]:
    """Yield messages in frames that nobody knows, as far as anybody sends transforms."""
    if not facts.transforms:
        return
    for heard in facts.heard:
        said = {"topic": heard.topic, "node": heard.node, "type": heard.type.rpartition("/")[2]}
        for frame in heard.frames if heard.type in PLACED else ():
            if frame and frame.lstrip("/") in facts.frames:
                continue
            near = nearest(frame.lstrip("/"), sorted(facts.frames))
            level = "warning" if near or _is_placed_by_somebody(heard.topic, facts) else "info"
            if not frame:
                yield finding(level, "empty_frame", **said, then=f"{_echo(heard)} --field header")
            else:
                then = "ros2 run tf2_tools view_frames"
                yield _or_near(level, "unknown_frame", near, **said, frame=frame, then=then)


def _or_near(level: str, key: str, near: str, *, then: str, **said: str) -> Finding:
    """The finding `key`, or where a name is near, the one that asks whether that was meant."""
    return (
        finding(level, f"{key}_near", **said, nearest=near, then=then)
        if near
        else finding(level, key, **said, then=then)
    )


def _is_placed_by_somebody(topic: str, facts: Facts) -> bool:
    """Whether somebody who listens to a topic listens to transforms, too: only then its frame matters."""
    by_frames = {each.node for each in facts.subscriptions.get("/tf", ())}
    return any(each.node in by_frames for each in facts.subscriptions.get(topic, ()))


@looks_at("messages", "nodes")
def of_stamps(facts: Facts) -> Iterator[Finding]:
    """Yield stamps that are 0 or of another clock than everybody's."""
    on_clock = {each.node for each in facts.subscriptions.get(CLOCK, ())}
    for heard in facts.heard:
        if heard.stamp is None or heard.type == JOINT_STATE or heard.node.endswith(PLAYER):
            continue
        if heard.stamp == 0 and heard.type not in (TRANSFORMS, *PLACED):
            continue  # of a trajectory, for instance, it means: at once
        said = {"topic": heard.topic, "node": heard.node}
        then = f"ros2 topic echo {heard.topic} --once"
        if heard.stamp == 0:
            level = "warning" if heard.type == TRANSFORMS or _is_placed_by_somebody(heard.topic, facts) else "info"
            yield finding(level, "stampless", **said, then=then)
        elif facts.clock is not None:
            if heard.node not in on_clock and abs(heard.ahead) < FAR < abs(heard.stamp - facts.clock):
                then = f"ros2 param set {heard.node} use_sim_time true"
                yield finding("warning", "stamp_clock", **said, then=then)
        elif heard.node not in on_clock and abs(heard.ahead) > FAR:
            key = "stamp_1970" if heard.stamp < LONG_AGO else "stamp_past" if heard.ahead < 0 else "stamp_future"
            yield finding("warning", key, **said, time=_long(abs(heard.ahead)), stamp=f"{heard.stamp:.1f}", then=then)


def _long(seconds: float) -> str:
    """Return a time as one says it to the minute: 1:00:00, or with days."""
    return str(timedelta(seconds=round(seconds / 60) * 60)).partition(",")[0]


@looks_at("frames")
def of_transforms(facts: Facts) -> Iterator[Finding]:
    """Yield a tree of frames that is none."""
    then = "ros2 run tf2_tools view_frames"
    parents: dict[str, list[str]] = {}
    for each in facts.transforms:
        nodes = ", ".join(each.nodes)
        if not each.parent or not each.child:
            yield finding(
                "error", "tf_nameless", nodes=nodes, frame=each.parent or each.child, then="ros2 topic echo /tf"
            )
            continue
        parents.setdefault(each.child, []).append(each.parent)
        if each.apart:
            yield finding("warning", "tf_fight", nodes=nodes, parent=each.parent, child=each.child, then=then)
    for child, several in parents.items():
        if len(several) > 1:
            nodes = ", ".join(sorted({node for each in facts.transforms if each.child == child for node in each.nodes}))
            yield finding("error", "two_parents", child=child, parents=", ".join(several), nodes=nodes, then=then)
    for loop in _loops({child: several[0] for child, several in parents.items()}):
        nodes = ", ".join(sorted({node for each in facts.transforms if each.child in loop for node in each.nodes}))
        yield finding("error", "tf_loop", frames=" → ".join((loop[0], *loop[::-1])), nodes=nodes, then=then)


def _loops(parents: dict[str, str]) -> Iterator[tuple[str, ...]]:
    """Yield the loops of a tree that is none, each once, from its first name."""
    done: set[str] = set()
    for start in sorted(parents):
        path: dict[str, None] = {}
        at: str | None = start
        while at is not None and at not in done and at not in path:
            path[at] = None
            at = parents.get(at)
        if at is not None and at in path:
            names = [*path]
            loop = names[names.index(at) :]
            first = loop.index(min(loop))
            yield (*loop[first:], *loop[:first])
        done |= {*path}


@looks_at("messages", "joints")
def of_positions(facts: Facts) -> Iterator[Finding]:
    """Yield joints beyond their limits, and trajectories for joints that the robot does not have."""
    if facts.robot is None:
        return
    limits = dict(facts.robot.limits)
    for heard in facts.heard:
        said = {"topic": heard.topic, "node": heard.node}
        for joint, position in heard.joints:
            if heard.type == TRAJECTORY and facts.joints is not None and joint not in facts.joints:
                near = nearest(joint, sorted(facts.joints))
                yield _or_near("error", "trajectory_joint", near, **said, joint=joint, then=_echo(heard))
            elif heard.type == JOINT_STATE and joint in limits:
                low, high = limits[joint]
                slack = BEYOND * (high - low)
                if position < low - slack or position > high + slack:
                    numbers = {"position": f"{position:g}", "low": f"{low:g}", "high": f"{high:g}"}
                    yield finding("warning", "joint_limits", **said, joint=joint, **numbers, then=_echo(heard))


@looks_at("messages")
def of_rival_descriptions(facts: Facts) -> Iterator[Finding]:
    """Yield robots of which two programs tell different things."""
    if facts.rival_descriptions:
        nodes = ", ".join(facts.rival_descriptions)
        yield finding("error", "two_descriptions", nodes=nodes, then="ros2 topic info -v /robot_description")
