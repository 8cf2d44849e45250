"""A submission as a good pupil hands it in, for tests to hand in and to spoil."""

from __future__ import annotations

import json
import subprocess
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path

from day6_core.lessons.grading.grader import Grader
from day6_core.lessons.grading.grades import Graded

STAR = """\
import time

import rclpy
from geometry_msgs.msg import Twist

rclpy.init()
node = rclpy.create_node('star')
keys = node.create_publisher(Twist, 'turtle1/cmd_vel', 10)
while keys.get_subscription_count() == 0:
    time.sleep(0.1)


def press(ahead, turn):
    order = Twist()
    order.linear.x = ahead
    order.angular.z = turn
    keys.publish(order)
    time.sleep(1.5)


for side in range(5):
    press(3.0, 0.0)
    press(0.0, 2.5132741)
"""

HELLO = """\
def main():
    print('This is my own package!')


if __name__ == '__main__':
    main()
"""

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):

    def __init__(self):
        super().__init__('day6_talker')
        self.mouth = self.create_publisher(String, 'chatter', 10)
        self.number = 0
        self.create_timer(0.5, self.speak)

    def speak(self):
        self.number += 1
        note = String()
        note.data = f'Hello {self.number}'
        self.mouth.publish(note)
        self.get_logger().info(f'said: {note.data}')


def main():
    rclpy.init()
    try:
        rclpy.spin(Talker())
    except KeyboardInterrupt:
        print('bye')


if __name__ == '__main__':
    main()
"""

LISTENER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):

    def __init__(self):
        super().__init__('day6_listener')
        self.create_subscription(String, 'chatter', self.hear, 10)

    def hear(self, note):
        self.get_logger().info(f'heard: {note.data}')


def main():
    rclpy.init()
    try:
        rclpy.spin(Listener())
    except KeyboardInterrupt:
        print('bye')


if __name__ == '__main__':
    main()
"""

SPINNER = """\
import math

import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState


class Spinner(Node):

    def __init__(self):
        super().__init__('wheel_spinner')
        self.out = self.create_publisher(JointState, 'joint_states', 10)
        self.create_timer(0.02, self.turn)
        self.angle = 0.0

    def turn(self):
        state = JointState()
        state.header.stamp = self.get_clock().now().to_msg()
        state.name = ['left_wheel_joint', 'right_wheel_joint']
        self.angle = (self.angle + 0.02) % (2 * math.pi)
        state.position = [self.angle, self.angle]
        self.out.publish(state)


def main():
    rclpy.init()
    try:
        rclpy.spin(Spinner())
    except KeyboardInterrupt:
        print('bye')


if __name__ == '__main__':
    main()
"""

_WHEEL = """\
  <link name="{side}_wheel">
    <visual>
      <origin xyz="0 0 0" rpy="1.5707963 0 0"/>
      <geometry><cylinder radius="0.05" length="0.03"/></geometry>
    </visual>
  </link>
  <joint name="{side}_wheel_joint" type="continuous">
    <parent link="base_link"/>
    <child link="{side}_wheel"/>
    <origin xyz="0 {y} 0.05" rpy="0 0 0"/>
    <axis xyz="0 1 0"/>
  </joint>
"""

URDF = (
    '<?xml version="1.0"?>\n<robot name="day6_bot">\n  <link name="base_link">\n    <visual>\n'
    '      <origin xyz="0 0 0.04" rpy="0 0 0"/>\n      <geometry><box size="0.4 0.25 0.08"/></geometry>\n'
    "    </visual>\n  </link>\n"
    + _WHEEL.format(side="left", y="0.15")
    + _WHEEL.format(side="right", y="-0.15")
    + "</robot>\n"
)

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    with open('/home/anna/ros2_ws/src/day6_publisher/urdf/day6_bot.urdf') as file:
        robot = file.read()
    return LaunchDescription([
        Node(
            package='robot_state_publisher',
            executable='robot_state_publisher',
            parameters=[{'robot_description': robot}],
        ),
    ])
"""

PACKAGE_XML = """\
<?xml version="1.0"?>
<package format="3">
  <name>day6_publisher</name>
  <version>0.0.0</version>
  <description>My first robot package</description>
  <maintainer email="anna@example.com">anna</maintainer>
  <license>MIT</license>
  <depend>rclpy</depend>
  <depend>std_msgs</depend>
  <depend>sensor_msgs</depend>
  <export><build_type>ament_python</build_type></export>
</package>
"""

SETUP = """\
import os
from glob import glob

from setuptools import find_packages, setup

package_name = 'day6_publisher'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*.launch.py')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='anna',
    maintainer_email='anna@example.com',
    description='My first robot package',
    license='MIT',
    entry_points={
        'console_scripts': [
            'hello = day6_publisher.hello:main',
            'talker = day6_publisher.talker:main',
            'listener = day6_publisher.listener:main',
            'wheel_spinner = day6_publisher.wheel_spinner:main',
        ],
    },
)
"""

TOP = "src/day6_publisher/"
INNER = TOP + "day6_publisher/"
FILES: dict[str, str] = {
    "home/star.py": STAR,
    TOP + "package.xml": PACKAGE_XML,
    TOP + "setup.py": SETUP,
    TOP + "setup.cfg": "[develop]\nscript_dir=$base/lib/day6_publisher\n[install]\n"
    "install_scripts=$base/lib/day6_publisher\n",
    TOP + "resource/day6_publisher": "",
    TOP + "urdf/day6_bot.urdf": URDF,
    TOP + "launch/day6_display.launch.py": LAUNCH,
    INNER + "__init__.py": "",
    INNER + "hello.py": HELLO,
    INNER + "talker.py": TALKER,
    INNER + "listener.py": LISTENER,
    INNER + "wheel_spinner.py": SPINNER,
}
MANIFEST = {"version": 1, "pupil": "安娜", "lesson": "", "home": "/home/anna", "answers": {}}


def write(target: Path, changed: Mapping[str, str | None] = {}, manifest: Mapping[str, object] = {}) -> Path:
    """Write a submission: the good one with some files changed, added or (None) left out."""
    files = {name: text for name, text in {**FILES, **changed}.items() if text is not None}
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("day6-submission.json", json.dumps({**MANIFEST, **manifest}))
        for name, text in files.items():
            archive.writestr(name, text)
    return target


class Patient(Grader):
    """A grader that plays nothing again: what is refused is refused, however busy the machine that runs the tests is."""

    def _again(self, graded: Graded) -> None:
        """Leave it as it was."""


def has_namespaces() -> bool:
    """Whether this system gives users some."""
    return (
        sys.platform == "linux"
        and subprocess.run(["unshare", "-Urpf", "true"], capture_output=True, check=False).returncode == 0
    )
