"""car_view: shows the robot of /robot_description from above, turning as /tf says; as text where there is no screen.

The parameter `tf_prefix` is what robot_state_publisher's `frame_prefix` puts before every frame. What it does without a screen is
the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from day6_core.ros.programs._robot_files import are_of_this_machine, share_folders
from day6_core.ros.programs._without_screen import stays
from day6_core.ros.programs.day6_bot.model import CarModel
from day6_core.ros.robot_check import newest_urdf
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread
from day6_urdf.load import RobotError, load_robot
from day6_urdf.topview.plan import TopPlan, plan_top
from day6_urdf.topview.view import render_top

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from day6_urdf.model import Vector

REFRESH_SECONDS = 0.5
"""How often to look at who publishes /joint_states; the picture itself follows every message."""

SETTLE_SECONDS = 2.0
"""Without a screen: how long to wait for a complete robot before it is printed as it is, unless its description is being read."""

SPEED_SECONDS = 0.5
"""And how long at least, so that speeds have been measured."""


DIRECTIONS = 16
TILTS = (-1.2, -0.6, 0.0, 0.6, 1.2)
"""Directions around the vertical, and angles to the level (radians), in which the corners of a mesh are looked for."""


async def main(session: Session) -> int:
    """Follow the robot until interrupted; without a display print it once (status 1 if there is none), or stay."""
    node = session.create_node("car_view")
    model = CarModel(node, partial(session.timer_ns, node))
    arrived = Signal()
    model.on_description = arrived.set
    session.spawn(_read_descriptions(session, model, arrived))
    if session.display is None and not stays(session, node):
        session.spawn(session.spin(node))
        return await _print(session, model)
    if session.display is not None:
        session.display.open("car", "car_view", model)
    session.spawn(_refresh(session, model))
    await session.spin(node)
    return 0


async def _read_descriptions(session: Session, model: CarModel, arrived: Signal) -> None:
    """Read every description that comes, in a thread: the first one loads yourdfpy."""
    while True:
        await session.wait(arrived)
        arrived.clear()
        text = model.waiting_description
        if text is not None:
            # What the thread may use of the session is copied now.
            trusted = are_of_this_machine(session, model.is_description)
            read = partial(_read, text, share_folders(session), trusted)
            plan, problem = await in_thread(read)
            if not arrived.is_set():
                model.show(plan, problem)


def _read(text: str, share_of: Callable[[str], str], trusted: bool) -> tuple[TopPlan | None, str]:
    try:
        robot = load_robot(text, newest_urdf())
    except RobotError as error:
        return None, str(error)
    if robot.loop:
        return None, f"the links form a loop: {' -> '.join(robot.loop)}"
    return plan_top(robot, partial(_outermost, share_of, trusted)), ""


def _outermost(share_of: Callable[[str], str], trusted: bool, name: str) -> Sequence[Vector]:
    """The corners of a mesh that stick out farthest, about its bounding hull; none if it cannot be read."""
    from day6_core.ros.programs.rviz2.model.meshes import MeshStore

    try:
        vertices = MeshStore(share_of, anywhere=trusted).read(name).vertices
    except (OSError, ValueError, MemoryError):
        return ()
    if not len(vertices):
        return ()
    turns = [2 * math.pi * step / DIRECTIONS for step in range(DIRECTIONS)]
    found = {}
    for x, y, z in ((math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b)) for a in turns for b in TILTS):
        index = int((vertices @ (x, y, z)).argmax())
        found[index] = (float(vertices[index][0]), float(vertices[index][1]), float(vertices[index][2]))
    return list(found.values())


async def _refresh(session: Session, model: CarModel) -> None:
    async for _ in session.every(REFRESH_SECONDS):
        model.refresh()


async def _print(session: Session, model: CarModel) -> int:
    async for step in session.every(0.1):
        model.refresh()
        moment = model.snapshot()
        whole = moment.robot is not None and len(moment.transforms) == len(moment.robot.links)
        patient = step * 0.1 < SETTLE_SECONDS or model.waiting_description is not None
        if (whole and moment.rate is not None and step * 0.1 >= SPEED_SECONDS) or not patient:
            break
    moment = model.snapshot()
    if moment.plan is not None:
        columns = max(min(session.stdout.columns, 80), 20)
        labels, turning = moment.labels(), moment.turning(0.0)
        for row in render_top(
            moment.plan, moment.transforms, columns, columns * 3 // 10, labels=labels, turning=turning
        ):
            session.print("".join(text for text, _ in row).rstrip())
    for line in moment.status:
        for text in textwrap.wrap(line.text, max(session.stdout.columns, 20), break_long_words=False):
            session.print(text)
    return 0 if moment.robot is not None else 1
