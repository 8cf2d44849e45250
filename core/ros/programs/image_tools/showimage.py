"""showimage: tells of each picture that comes; there is no window of OpenCV for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from day6_tui.core.ros.programs.image_tools._components import ShowImage
from day6_tui.core.ros.programs.image_tools._running import run

if TYPE_CHECKING:
    from day6_tui.core.session.session import Session

USAGE = """\
Usage: showimage [-h] [--ros-args [-p param:=value] ...]
Subscribe to an image topic and show the images.
Example: ros2 run image_tools showimage --ros-args -p reliability:=best_effort

Options:
  -h, --help\tDisplay this help message and exit

Parameters:
  reliability\tReliability QoS setting. Either 'reliable' (default) or 'best_effort'
  history\tHistory QoS setting. Either 'keep_last' (default) or 'keep_all'.
\t\tIf 'keep_last', then up to N samples are stored where N is the depth
  depth\t\tDepth of the publisher queue. Only honored if history QoS is 'keep_last'. Default value is 10
  show_image\tShow the image. Either 'true' (default) or 'false'
  window_name\tName of the display window. Default value is the topic name"""


async def main(session: Session) -> int:
    return await run(session, USAGE, ShowImage.NAME, lambda node: ShowImage(node, session.print_error))
