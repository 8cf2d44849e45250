"""`ros2 run joint_state_publisher_gui joint_state_publisher_gui [FILE]`: a slider for every joint that can move.

Its node is called joint_state_publisher, as in the original. Without a screen it publishes on, with all joints at zero,
and says so (see `programs/_without_screen.py`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.joint_state_publisher.joint_state_publisher import make_publisher
from day6_core.ros.programs.joint_state_publisher_gui.model import SliderModel
from day6_core.session.task import Signal

if TYPE_CHECKING:
    from day6_core.session.session import Session

LOOK_SECONDS = 0.5
"""How often to look for other publishers."""


async def main(session: Session) -> int:
    publisher = make_publisher(session, "urdf_file", "URDF file to use")
    if isinstance(publisher, int):
        return publisher
    model = SliderModel(publisher, seed=session.clock.now_ns())
    if publisher.joints.names:
        model.take_joints()
    if session.display is None:
        publisher.node.get_logger().warning("There is no screen for the sliders: every joint stays at its zero")
    else:
        session.display.open("joint_state_publisher", "Joint State Publisher", model)
        requested = Signal()
        model.on_request = requested.set
        session.spawn(_handle_requests(session, model, requested))
        session.spawn(_look_around(session, model))
    try:
        await session.spin(publisher.node)
    except SystemExit as end:
        return int(end.code or 0)
    return 0


async def _handle_requests(session: Session, model: SliderModel, requested: Signal) -> None:
    while True:
        await session.wait(requested)
        requested.clear()
        model.handle_requests()


async def _look_around(session: Session, model: SliderModel) -> None:
    model.look_around()
    async for _ in session.every(LOOK_SECONDS):
        model.look_around()
