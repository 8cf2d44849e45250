"""Checks of robots: URDF files, the published description, RViz."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.lessons.checks import Verdict, check
from day6_core.lessons.checks.files import Unreadable, read
from day6_core.lessons.texts import Say

if TYPE_CHECKING:
    from day6_core.lessons.live import Live
    from day6_core.ros.programs.rviz2.model.display import Display
    from day6_core.ros.programs.rviz2.model.manager import RViz
    from day6_urdf.model import Joint, Robot

CLOSE = 1e-6
"""Metres by which a number of a file may differ."""


@check("urdf", paths=("file",))
def urdf(
    live: Live,
    file: str,
    name: str = "",
    links: list[str] | None = None,
    joints: list[str] | None = None,
    joint: str = "",
    type_: str = "",
    parent: str = "",
    child: str = "",
    axis: str = "",
    xyz: str = "",
) -> Verdict:
    from day6_core.ros.robot_check import check_robot

    wanted = Say("urdf", path=file)
    try:
        text = read(live.path(file))
    except Unreadable as error:
        return Verdict(False, wanted, Say("file.unread", path=file, reason=error))
    if text is None:
        return Verdict(False, wanted, Say("file.saw_none", path=file))
    report = check_robot(text)
    robot = report.robot
    if robot is None:
        reason = report.diagnostics[0].text.strip() if report.diagnostics else "?"
        return Verdict(False, wanted, Say("urdf.saw", reason=reason))
    if name and robot.name != name:
        return Verdict(False, Say("urdf.name", path=file, name=name), Say("urdf.joint_saw", found=robot.name))
    for key, needed, there in (
        ("links", links, tuple(each.name for each in robot.links)),
        ("joints", joints, tuple(each.name for each in robot.joints)),
    ):
        if needed:
            wanted = Say(f"urdf.{key}", path=file, names=tuple(needed))
        if needed and not set(needed) <= set(there):
            return Verdict(False, wanted, Say("urdf.has", names=there))
    if joint:
        wants = {"type": type_, "parent": parent, "child": child, "axis": axis, "xyz": xyz}
        return _joint(robot, joint, {key: value for key, value in wants.items() if value}, file)
    return Verdict(True, wanted)


def _joint(robot: Robot, name: str, wants: dict[str, str], file: str) -> Verdict:
    found = next((each for each in robot.joints if each.name == name), None)
    if found is None:
        there = tuple(each.name for each in robot.joints)
        return Verdict(False, Say("urdf.joints", path=file, names=(name,)), Say("urdf.has", names=there))
    wanted = Say("urdf.joints", path=file, names=(name,))
    for what, value in wants.items():
        wanted = Say("urdf.joint", joint=name, what=what, value=value)
        is_so, shown = _joint_has(found, what, value)
        if not is_so:
            return Verdict(False, wanted, Say("urdf.joint_saw", found=shown))
    return Verdict(True, wanted)


def _joint_has(joint: Joint, what: str, value: str) -> tuple[bool, str]:
    """Whether a joint is so, and how it is."""
    if what in ("axis", "xyz"):
        vector = joint.axis if what == "axis" else joint.origin.xyz
        numbers = [float(each) for each in value.split()]
        is_so = len(numbers) == 3 and all(abs(a - b) <= CLOSE for a, b in zip(vector, numbers, strict=True))
        return is_so, " ".join(f"{each:g}" for each in vector)
    found = str(getattr(joint, what))
    return found == value, found


@check("description", names=("topic",))
def description(live: Live, joints: list[str] | None = None, topic: str = "/robot_description") -> Verdict:
    from day6_core.ros.robot_check import check_robot
    from day6_urdf.model import MOVING_TYPES

    wanted = Say("description.joints", names=tuple(joints)) if joints else Say("description")
    heard = live.heard(topic)
    last = heard.since(heard.count - 1) if heard.count else []
    if not last or not live.publishers(topic):
        return Verdict(False, wanted, Say("description.saw_none"))
    report = check_robot(str(getattr(last[-1][1], "data", "")))
    if report.robot is None:
        return Verdict(False, wanted, Say("urdf.saw", reason=report.diagnostics[0].text if report.diagnostics else "?"))
    there = tuple(each.name for each in report.robot.joints if each.type in MOVING_TYPES or each.name in (joints or ()))
    ok = set(joints or ()) <= set(there)
    return Verdict(ok, wanted, None if ok else Say("urdf.has", names=there))


@check("rviz")
def rviz(live: Live, fixed_frame: str = "", display: str = "", status: str = "") -> Verdict:
    windows = live.windows("rviz2")
    if not windows:
        return Verdict(False, Say("rviz"), Say("rviz.saw_none"))
    model: Any = windows[-1].model
    manager: RViz = model
    wanted = Say("rviz")
    if fixed_frame:
        wanted = Say("rviz.frame", frame=fixed_frame)
        if manager.fixed_frame != fixed_frame:
            return Verdict(False, wanted, Say("rviz.saw_frame", frame=manager.fixed_frame))
    if not display:
        return Verdict(True, wanted)
    shown = [each for each in manager.displays if each.enabled]
    of_type = [each for each in shown if each.type == display]
    if not of_type:
        return Verdict(
            False,
            Say("rviz.display", display=display),
            Say("rviz.saw_displays", displays=tuple(each.type for each in shown)),
        )
    wanted = Say("rviz.display", display=display)
    if status:
        wanted = Say("rviz.status", display=display, status=status)
        words = [_status(each) for each in of_type]
        if not any(word == status.lower() for word, _ in words):
            return Verdict(False, wanted, Say("rviz.saw_status", status=words[0][0], reason=words[0][1]))
    return Verdict(True, wanted)


def _status(display: Display) -> tuple[str, str]:
    """The word of a display's status, small letters, and the first line that is not well."""
    from day6_core.ros.programs.rviz2.model.status import WORDS, Status

    worst = display.statuses
    lines = [each for each in worst.children if isinstance(each, Status) and each.level == worst.level]
    reason = f"{lines[0].name}: {lines[0].value}" if lines else ""
    return WORDS[worst.level].lower(), reason
