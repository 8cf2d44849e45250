"""`ros2 run rqt_robot_steering rqt_robot_steering`: drives a robot by two sliders.

What it does without a screen is the rule of `programs/_without_screen.py`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from day6_core.ros import differences
from day6_core.ros.programs.rqt_gui.plugin import Plugin, PluginPlace, Settings, run_alone
from day6_core.ros.programs.rqt_robot_steering.model import PERIOD, RobotSteering
from day6_core.session.session import Session
from rclpy.parameter import Parameter

if TYPE_CHECKING:
    from rclpy.node import Node

REFRESH_SECONDS = 0.1
"""At most this often is the graph looked at again while it changes."""

PARAMETERS = {
    "topic": Parameter.Type.STRING,
    "stamped": Parameter.Type.BOOL,
    "vx_min": Parameter.Type.DOUBLE,
    "vx_max": Parameter.Type.DOUBLE,
    "vw_min": Parameter.Type.DOUBLE,
    "vw_max": Parameter.Type.DOUBLE,
}
"""What `default_<name>` stands for, by its name in a perspective, over which it takes precedence."""


class RobotSteeringPlugin(Plugin[RobotSteering]):
    """rqt_robot_steering/RobotSteering."""

    kind, title = "rqt_robot_steering", "Robot Steering"

    def __init__(self, place: PluginPlace) -> None:
        settings: Mapping[str, Any] = place.settings
        if differences.value("rqt_robot_steering.parameters"):
            settings = {**settings, **_given(place.node)}
        stamped = differences.value("rqt_robot_steering.stamped")
        super().__init__(place, RobotSteering(place.node, settings, place.session.print, stamped=stamped))

    async def run(self) -> None:
        self.place.serve(self.model)
        self.place.spawn(self.place.repeat(self.model.publish, PERIOD, lambda: self.model.is_due))
        await self.place.follow(self.model.refresh, REFRESH_SECONDS)

    def close(self) -> None:
        self.model.close()

    def settings(self) -> Settings:
        return self.model.kept()


def _given(node: Node) -> dict[str, Any]:
    """The values of the parameters that are set."""
    given = {}
    for key, kind in PARAMETERS.items():
        name = f"default_{key}"
        if not node.has_parameter(name):  # a second plugin on the same node finds them
            node.declare_parameter(name, kind)
        value = node.get_parameter_or(name).value
        if value is not None:
            given[key] = value
    return given


async def main(session: Session) -> int | None:
    """Open the window and publish until interrupted."""
    return await run_alone(session, RobotSteeringPlugin)
