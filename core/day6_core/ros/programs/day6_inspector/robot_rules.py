"""Rules about the robot: joint states, its description, RViz, the world."""

from __future__ import annotations

from collections.abc import Iterator

from day6_core.facts.graph import node_names
from day6_core.facts.names import nearest
from day6_core.ros.programs.day6_inspector.facts import Facts, RVizView
from day6_core.ros.programs.day6_inspector.finding import Finding, finding
from day6_core.ros.programs.day6_inspector.sight import looks_at

DESCRIPTION = "/robot_description"
JOINT_STATE = "sensor_msgs/msg/JointState"


@looks_at("joints", "messages")
def of_joints(facts: Facts) -> Iterator[Finding]:
    """Yield joints that joint states and description do not have in common, and unequal lists."""
    if facts.unequal_joints is not None:
        names, positions = facts.unequal_joints
        then = f"ros2 topic echo {facts.joint_states} --once"
        yield finding("error", "unequal_joints", topic=facts.joint_states, names=names, positions=positions, then=then)
    if not facts.heard_joints:
        return
    if facts.joints is not None and facts.timeless_joints and facts.subscriptions.get(facts.joint_states):
        then = f"ros2 topic echo {facts.joint_states} --once --field header"
        yield finding("error", "no_stamp", topic=facts.joint_states, then=then)
    if facts.joints is not None:
        yield from _unlike(facts, facts.joints)


def _unlike(facts: Facts, joints: frozenset[str]) -> Iterator[Finding]:
    """One answer for each joint that is on one side only: who sends it, what it should be called, what has no place now."""
    links = dict(facts.robot.moved) if facts.robot is not None else {}
    said = {"topic": facts.joint_states, "nodes": node_names(facts.publishers.get(facts.joint_states, ())) or "?"}
    echo = f"ros2 topic echo {facts.joint_states} --once"
    free = sorted(joints - set(facts.heard_joints))
    unknown = [joint for joint in facts.heard_joints if joint not in joints]
    for joint in list(unknown):
        near = nearest(joint, free, 0.5)
        if near:
            free.remove(near)
            unknown.remove(joint)
            place = {"nearest": near, "link": links.get(near, near)}
            yield finding("error", "unknown_joint_near", **said, joint=joint, **place, then=echo)
    lost = {"links": ", ".join(links.get(each, each) for each in free)}
    if unknown and free:
        them = {"joint": ", ".join(unknown), "joints": ", ".join(free)}
        yield finding("error", "other_joints", **said, **them, **lost, then=echo)
    elif unknown:
        yield finding("error", "unknown_joint", **said, joint=", ".join(unknown), then=echo)
    elif free:
        yield finding("warning", "silent_joint", **said, joint=", ".join(free), **lost, then=echo)


def waits_for_joints(facts: Facts) -> bool:
    """Whether robot_state_publisher has a robot with joints that can move, and nobody publishes joint states."""
    listens = any(each.type == JOINT_STATE for each in facts.subscriptions.get(facts.joint_states, ()))
    return bool(facts.joints) and listens and facts.joint_states not in facts.publishers


@looks_at("joints", "topics")
def of_missing_joints(facts: Facts) -> Iterator[Finding]:
    """Yield that nobody says where a robot's moving parts are: an error where RViz waits for it."""
    if facts.robot is not None and facts.robot.moved and waits_for_joints(facts):
        lost = {link for _, link in facts.robot.moved}
        missed = any(lost & {*view.untransformed} for view in facts.rviz)
        joints, links = (", ".join(each) for each in zip(*facts.robot.moved, strict=True))
        then = "ros2 run joint_state_publisher joint_state_publisher"
        said = {"topic": facts.joint_states, "joints": joints, "links": links}
        yield finding("error" if missed else "info", "no_joint_states", **said, then=then)


@looks_at("joints", "topics")
def of_description(facts: Facts) -> Iterator[Finding]:
    """Yield a missing robot_state_publisher, and mistakes in the description that parsers accept."""
    described = DESCRIPTION in facts.publishers
    start = "ros2 run robot_state_publisher robot_state_publisher my_car.urdf"
    senders = facts.publishers.get(facts.joint_states, ())
    heard = facts.subscriptions.get(facts.joint_states, ())
    if not described and any(each.type == JOINT_STATE for each in senders) and not heard:
        yield finding("warning", "no_state_publisher", topic=facts.joint_states, nodes=senders[0].node, then=start)
    elif not described and any("RobotModel" in view.displays for view in facts.rviz):
        yield finding("error", "rviz_no_description", then=start)
    if facts.robot is None:
        return
    if facts.robot.problem:
        then = "ros2 topic echo /robot_description --once --full-length"
        yield finding("error", "bad_description", reason=facts.robot.problem, then=then)
    for key, parameters in facts.robot.mistakes:
        yield finding("warning", key, **dict(parameters))


@looks_at("windows", "frames")
def of_rviz(facts: Facts) -> Iterator[Finding]:
    """Yield what an RViz window cannot show, and why."""
    moved = dict(facts.robot.moved) if facts.robot is not None else {}
    explained = {link for joint, link in moved.items() if joint not in facts.heard_joints}
    for view in facts.rviz:
        known = view.fixed_frame in view.frames
        if not known and view.frames:
            frame = nearest(view.fixed_frame, view.frames) or root_of(view)
            said = {"frame": view.fixed_frame, "other": frame, "frames": ", ".join(sorted(view.frames)[:6])}
            yield finding("error", "fixed_frame", **said, then="ros2 run tf2_tools view_frames")
        elif not known and DESCRIPTION in facts.publishers:
            said = {"frame": view.fixed_frame}
            yield finding("warning", "no_transforms", **said, then="ros2 topic info /tf")
        elif lost := [link for link in view.untransformed if link not in explained]:
            links = ", ".join(lost[:4])
            said = {"links": links, "frame": view.fixed_frame}
            then = f"ros2 topic echo {facts.joint_states} --once"
            yield finding("error", "untransformed", **said, then=then)
        if DESCRIPTION not in facts.publishers:
            continue
        if "RobotModel" not in view.displays:
            yield finding("warning", "no_robot_model")
        elif not view.described:
            topic = view.description_topic or '""'
            yield finding("warning", "robot_model_deaf", topic=topic, right=DESCRIPTION)


def root_of(view: RVizView) -> str:
    """Return the frame a beginner probably means: base_link or the like, else the first."""
    return next(
        (each for each in ("base_link", "base_footprint", "odom", "world") if each in view.frames), view.frames[0]
    )


@looks_at("windows")
def of_world(facts: Facts) -> Iterator[Finding]:
    """Yield why a robot may not enter the world, or is a ghost there: the remarks below the world's picture."""
    for identifier, parameters in facts.world:
        level = "error" if identifier in ("world.no_inertial", "world.refused", "world.bad_mass") else "warning"
        yield Finding(level, identifier, parameters)
