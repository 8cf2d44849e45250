"""cam2image: pictures of burgers; of a camera where there is one, which is never here."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_core.ros.programs.image_tools._components import Cam2Image
from day6_core.ros.programs.image_tools._running import run

if TYPE_CHECKING:
    from day6_core.session.session import Session

USAGE = """\
Usage: cam2image [-h] [--ros-args [-p param:=value] ...]
Publish images from a camera stream.
Example: ros2 run image_tools cam2image --ros-args -p reliability:=best_effort

Options:
  -h, --help\tDisplay this help message and exit

Parameters:
  reliability\tReliability QoS setting. Either 'reliable' (default) or 'best_effort'
  history\tHistory QoS setting. Either 'keep_last' (default) or 'keep_all'.
\t\tIf 'keep_last', then up to N samples are stored where N is the depth
  depth\t\tDepth of the publisher queue. Only honored if history QoS is 'keep_last'. Default value is 10
  frequency\tPublish frequency in Hz. Default value is 30
  burger_mode\tProduce images of burgers rather than connecting to a camera
  show_camera\tShow camera stream. Either 'true' or 'false' (default)
  device_id\tDevice ID of the camera. 0 (default) selects the default camera device.
  width\t\tWidth component of the camera stream resolution. Default value is 320
  height\tHeight component of the camera stream resolution. Default value is 240
  frame_id\t\tID of the sensor frame. Default value is 'camera_frame'

Note: try running v4l2-ctl --list-formats-ext to obtain a list of valid values."""


async def main(session: Session) -> int:
    return await run(session, USAGE, Cam2Image.NAME, lambda node, window: Cam2Image(node, window.show))
