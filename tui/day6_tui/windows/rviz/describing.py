"""Describes the view in words: for people who cannot see it well, and for those who do not know what they see."""

from __future__ import annotations

import colorsys
import math

from day6_core.ros.programs.rviz2.model.display import FailedDisplay
from day6_core.ros.programs.rviz2.model.displays.robot_model import RobotModelDisplay
from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.properties import number_text
from day6_core.ros.programs.rviz2.model.topics import FilteredDisplay
from day6_tui.locale import Texts
from day6_urdf.kinematics import compose, inverse
from day6_urdf.model import Joint

HUES = ((15, "red"), (40, "orange"), (70, "yellow"), (165, "green"), (200, "cyan"), (260, "blue"), (330, "purple"))

MOST_LINKS = 6
"""Of a robot with more links, the rest are counted."""


def colour_word(colour: tuple[float, ...], texts: Texts) -> str:
    """The name of a colour."""
    hue, lightness, saturation = colorsys.rgb_to_hls(*(max(0.0, min(1.0, part)) for part in colour[:3]))
    if saturation < 0.18 or lightness < 0.08 or lightness > 0.95:
        key = "black" if lightness < 0.12 else "dark" if lightness < 0.35 else "grey" if lightness < 0.85 else "white"
    else:
        key = next((name for limit, name in HUES if hue * 360 < limit), "red")
    return texts(f"rviz.colour.{key}")


def described(rviz: RViz, texts: Texts) -> str:
    """One sentence for each enabled display, joined."""
    phrases: list[str] = []
    for display in rviz.displays:
        if not display.enabled or display.type == "Group":
            continue
        if isinstance(display, RobotModelDisplay):
            phrases += _robot(display, texts)
        elif display.type == "Grid":
            cells = display.child("Plane Cell Count").text
            size = display.child("Cell Size").text
            phrases.append(texts("rviz.seen.grid", cells=cells, size=size))
        elif display.type == "TF":
            count = len(getattr(display, "frames", {}))
            phrases.append(texts("rviz.seen.frames", count=count) if count else texts("rviz.seen.no_frames"))
        elif display.type == "Axes":
            phrases.append(texts("rviz.seen.axes", frame=display.child("Reference Frame").text))
        elif isinstance(display, FailedDisplay):
            missing = display.missing
            phrases.append(f"{display.name}: {texts(missing.id, **dict(missing.parameters))}")
        elif display.type == "InteractiveMarkers":
            count = len(getattr(display, "markers", {}))
            phrases.append(texts("rviz.seen.markers", name=display.name, count=count))
        elif isinstance(display, FilteredDisplay) and not display.received and display.waiting:
            frame, fixed = display.waiting_for, rviz.fixed_frame
            count = display.waiting
            phrases.append(texts("rviz.seen.waiting", name=display.name, count=count, frame=frame, fixed=fixed))
        elif isinstance(display, FilteredDisplay) and not display.received and display.nameless:
            phrases.append(texts("rviz.seen.nameless", name=display.name, count=display.nameless))
        elif count := getattr(display, "points_shown", 0):
            key = "rviz.seen.point" if count == 1 else "rviz.seen.points"
            phrases.append(texts(key, name=display.name, count=count))
        elif size := getattr(display, "picture_size", ""):
            phrases.append(texts("rviz.seen.image", name=display.name, size=size))
        else:
            phrases.append(texts("rviz.seen.messages", name=display.name, count=getattr(display, "received", 0)))
    separator = texts("rviz.seen.separator")
    return separator.join(phrases) if phrases else texts("rviz.seen.nothing")


def _robot(display: RobotModelDisplay, texts: Texts) -> list[str]:
    robot = display.parts.robot
    if robot is None:
        return [texts("rviz.seen.no_robot")]
    joints = {joint.child: joint for joint in robot.joints}
    phrases: list[str] = []
    shown = [name for name, parts in display.parts.links.items() if parts.visual and display.links.enabled(name)]
    if len(shown) > 1 and all(name in display.lost for name in shown):
        return [texts("rviz.seen.all_lost", name=robot.name, frame=display.rviz.fixed_frame)]
    for name in shown[:MOST_LINKS]:
        part = display.parts.links[name].visual[0]
        size = _size(part.kind, part.size)
        text = texts(
            "rviz.seen.link",
            colour=colour_word((1.0, 1.0, 1.0) if name in display.lost else part.colour, texts),
            kind=texts(f"rviz.kind.{part.kind}"),
            name=name,
            size=texts("rviz.seen.metres", size=size) if size else "",
        )
        if name in display.lost:
            text += texts("rviz.seen.lost")
        elif name in joints and (turned := _turned(display, joints[name])) is not None:
            text += texts("rviz.seen.turned", degrees=turned)
        phrases.append(text)
    if len(shown) > MOST_LINKS:
        phrases.append(texts("rviz.seen.more", count=len(shown) - MOST_LINKS))
    return [texts("rviz.seen.robot", name=robot.name, parts=texts("rviz.seen.comma").join(phrases))]


def _size(kind: str, size: tuple[float, float, float]) -> str:
    if kind == "box":
        return "×".join(number_text(each) for each in size)
    if kind == "cylinder":
        return f"⌀{number_text(size[0])}×{number_text(size[2])}"
    if kind == "sphere":
        return f"⌀{number_text(size[0])}"
    return ""


def _turned(display: RobotModelDisplay, joint: Joint) -> int | None:
    """Whole degrees by which a revolute joint is turned from zero, from the drawn poses."""
    if joint.type not in ("continuous", "revolute"):
        return None
    parent, child = display.pose(joint.parent), display.pose(joint.child)
    relative = compose(inverse(joint.origin), compose(inverse(parent), child)).rotation
    length = math.sqrt(sum(part * part for part in joint.axis)) or 1.0
    along = sum(a * b for a, b in zip(relative, joint.axis, strict=False)) / length
    return round(math.degrees(2 * math.atan2(along, relative[3]))) % 360
