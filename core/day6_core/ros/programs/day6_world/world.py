"""`ros2 run day6_world world`: a world in which a robot drives.

Parameters: `world` (empty, walls, maze, line, or a file), `robot_file` (a URDF; without one the robot is that of
/robot_description), `x`, `y`, `yaw` (where it starts; yaw in radians), `seed`, `speed` (how fast time passes), `stamped`
(hear TwistStamped on /cmd_vel), `follow_joint_states` (let the wheels do what others say on /joint_states), `left_wheels`
and `right_wheels` (joints; found by themselves otherwise), `lidar_link`, `lidar_noise` (m), `publish_clock`.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from day6_core.reason import named_reason
from day6_core.ros.programs.day6_world._simulation import STEP
from day6_core.ros.programs.day6_world._world_node import WorldNode
from day6_core.ros.programs.day6_world.scenery import Scenery, SceneryError, read_scenery, shipped_worlds
from day6_core.ros.robot_check import check_robot
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread
from day6_urdf.check import MAX_BYTES, read_description, too_large

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from day6_urdf.model import Robot
    from rclpy.node import Node

LOOK_SECONDS = 0.5
"""How often to look at who publishes what."""


async def main(session: Session) -> int:
    node = session.create_node("world")
    try:
        scenery = _scenery(session, node)
        world = WorldNode(node, scenery, partial(session.timer_ns, node), session.clock.wall_ns)
        text = _robot_file(session, node)
    except (SceneryError, OSError) as error:
        node.get_logger().fatal(named_reason(error))
        return 1
    world.model.is_held = lambda: session.clock.paused
    described = Signal()
    world.on_description = described.set
    if text is not None:
        world.hear_text(text)
    if session.display is not None:
        session.display.open("world", f"world: {scenery.name}", world.model)
    session.executor.add_node(node)
    session.spawn(_read_descriptions(session, world, described))
    session.spawn(_look_around(session, world))
    async for _ in session.every(STEP):
        session.spin_some()
        world.tick()
    return 0


def _scenery(session: Session, node: Node) -> Scenery:
    """Return the world of the parameter `world`. Raises SceneryError, OSError."""
    from ament_index_python.packages import get_package_share_path

    name = str(node.declare_parameter("world", "empty").value)
    shipped = shipped_worlds(get_package_share_path("day6_world"))
    if name in shipped:
        return read_scenery(shipped[name])
    path = session.cwd / name
    if not path.exists():
        raise SceneryError(f"there is no world '{name}': it is one of {', '.join(shipped)}, or a file")
    try:
        return read_scenery(path)
    except SceneryError as error:
        raise SceneryError(f"{name}: {error}") from error


def _robot_file(session: Session, node: Node) -> str | None:
    name = node.declare_parameter("robot_file", "").value
    if not name:
        return None
    text, size = read_description(session.cwd / name)
    if size > MAX_BYTES:
        raise SceneryError(f"{name}: {too_large(size).diagnostics[0].text}")
    return text


async def _read_descriptions(session: Session, world: WorldNode, described: Signal) -> None:
    while True:
        await session.wait(described)
        described.clear()
        text = world.waiting_description
        if text is not None:
            robot, problem = await in_thread(lambda text=text: _read(text))  # type: ignore[misc]
            if not described.is_set():
                world.admit(robot, problem)


def _read(text: str) -> tuple[Robot | None, str]:
    """Return the robot (None if it is refused) and what was wrong with its description."""
    report = check_robot(text)
    robot, errors = report.robot, [diagnostic.text for diagnostic in report.diagnostics if diagnostic.level == "Error"]
    if robot is not None and robot.loop:
        return None, f"the links form a loop: {' -> '.join(robot.loop)}"
    return robot, errors[-1 if robot is None else 0] if errors else ""


async def _look_around(session: Session, world: WorldNode) -> None:
    async for _ in session.every(LOOK_SECONDS):
        world.look_around()
