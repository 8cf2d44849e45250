"""Whether the night lamp of drill 37 takes its numbers from its file: it is run once more, unseen, with another number.

It runs in a domain of its own; neither the pupil's files nor his nodes are touched.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from std_msgs.msg import Int32

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

FOLDER = Path.home() / "drill37"
GIVEN = "lamp:\n  ros__parameters:\n    brightness: 80\n"
HIDDEN = 37
DOMAIN = 137
SECONDS = 4.0


def main() -> int:
    """Print what was seen; return 0 if the lamp shone as its file said."""
    settings = (FOLDER / "lamp.yaml").read_text(encoding="utf-8")
    program = (FOLDER / "lamp.py").read_text(encoding="utf-8")
    if settings == GIVEN and "'brightness', 10, fixed" in program:
        print("还没有改动 (nothing has been changed yet)")
        return 1
    changed, numbers = re.subn(r"(brightness\s*:\s*)80\b", rf"\g<1>{HIDDEN}", settings)
    if not numbers:
        print("lamp.yaml 里没有亮度 80 (lamp.yaml has no brightness of 80)")
        return 1
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "other.yaml"
        with file.open("w", encoding="utf-8") as other:
            other.write(changed)
        command = ["python3", str(FOLDER / "lamp.py"), "--ros-args", "--params-file", str(file)]
        environment = {**os.environ, "ROS_DOMAIN_ID": str(DOMAIN)}
        quiet = subprocess.DEVNULL
        with subprocess.Popen(command, env=environment, stdout=quiet, stderr=quiet) as lamp:
            try:
                shown = first_brightness()
            finally:
                lamp.kill()
    if shown is None:
        print("文件里换一个数，灯就不亮了 (with another number in the file it doesn't shine)")
    elif shown != HIDDEN:
        print(f"文件里换一个数，亮度还是 {shown} (with another number in the file it is still {shown})")
    else:
        print("灯听文件的话 (the lamp follows its file)")
    return 0 if shown == HIDDEN else 1


def first_brightness() -> int | None:
    """The first number on /brightness in the hidden domain, None if none comes."""
    heard: list[int] = []
    rclpy.init(domain_id=DOMAIN)
    node = Node("lamp_check")
    node.create_subscription(Int32, "brightness", lambda message: heard.append(message.data), 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    waited = 0.0
    while not heard and waited < SECONDS:
        executor.spin_once(timeout_sec=0.1)
        waited += 0.1
    node.destroy_node()
    rclpy.shutdown()
    return heard[0] if heard else None


if __name__ == "__main__":
    sys.exit(main())
