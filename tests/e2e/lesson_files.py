"""The files of the lesson, as a student copies them from the article (its sections 3.2, 4.4, 5.1 and 5.3)."""

from __future__ import annotations

TALKER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__('day6_talker')
        self.publisher_ = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(0.5, self.timer_callback)
        self.count = 0

    def timer_callback(self):
        msg = String()
        msg.data = 'Hello from Day 6: %d' % self.count
        self.publisher_.publish(msg)
        self.get_logger().info('Publishing: %s' % msg.data)
        self.count += 1

def main(args=None):
    rclpy.init(args=args)
    node = Talker()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()

if __name__ == '__main__':
    main()
"""

WHEEL_SPINNER = """\
import math
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState

class WheelSpinner(Node):
    def __init__(self):
        super().__init__('wheel_spinner')
        self.publisher_ = self.create_publisher(JointState, 'joint_states', 10)
        self.timer = self.create_timer(0.02, self.timer_callback)
        self.angle = 0.0

    def timer_callback(self):
        msg = JointState()
        msg.header.stamp = self.get_clock().now().to_msg()
        msg.name = ['left_wheel_joint', 'right_wheel_joint']
        self.angle += 0.02
        self.angle %= (2 * math.pi)
        msg.position = [self.angle, self.angle]
        self.publisher_.publish(msg)

def main(args=None):
    rclpy.init(args=args)
    node = WheelSpinner()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()

if __name__ == '__main__':
    main()
"""

URDF = """\
<?xml version="1.0"?>
<robot name="day6_bot">
  <link name="base_link">
    <visual>
      <origin xyz="0 0 0.04" rpy="0 0 0"/>
      <geometry><box size="0.4 0.25 0.08"/></geometry>
      <material name="blue"><color rgba="0.2 0.3 0.9 1.0"/></material>
    </visual>
  </link>
  <joint name="left_wheel_joint" type="continuous">
    <parent link="base_link"/>
    <child link="left_wheel"/>
    <origin xyz="0 0.15 0.05" rpy="0 0 0"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="left_wheel">
    <visual>
      <origin xyz="0 0 0" rpy="1.5707963 0 0"/>
      <geometry><cylinder radius="0.05" length="0.03"/></geometry>
      <material name="dark"><color rgba="0.2 0.2 0.2 1.0"/></material>
    </visual>
  </link>
  <joint name="right_wheel_joint" type="continuous">
    <parent link="base_link"/>
    <child link="right_wheel"/>
    <origin xyz="0 -0.15 0.05" rpy="0 0 0"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="right_wheel">
    <visual>
      <origin xyz="0 0 0" rpy="1.5707963 0 0"/>
      <geometry><cylinder radius="0.05" length="0.03"/></geometry>
      <material name="dark"/>
    </visual>
  </link>
  <joint name="caster_joint" type="fixed">
    <parent link="base_link"/>
    <child link="caster"/>
    <origin xyz="0.1 0 0.02" rpy="0 0 0"/>
  </joint>
  <link name="caster">
    <visual>
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <geometry><sphere radius="0.02"/></geometry>
      <material name="gray"><color rgba="0.7 0.7 0.7 1.0"/></material>
    </visual>
  </link>
</robot>
"""

LAUNCH = """\
import os
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    urdf_path = '@HOME@/ros2_ws/src/day6_publisher/urdf/day6_bot.urdf'
    with open(urdf_path, 'r') as f:
        robot_description = f.read()
    return LaunchDescription([
        Node(
            package='robot_state_publisher',
            executable='robot_state_publisher',
            parameters=[{'robot_description': robot_description}],
        ),
        Node(
            package='rviz2',
            executable='rviz2',
            name='rviz2',
        ),
    ])
"""
"""`@HOME@` is what the article calls /home/your_name."""

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
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*.launch.py')),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='student',
    maintainer_email='student@todo.todo',
    description='TODO: Package description',
    license='TODO: License declaration',
    tests_require=['pytest'],
    entry_points={
        'console_scripts': [
@SCRIPTS@        ],
    },
)
"""

TALKER_SCRIPT = "            'talker = day6_publisher.talker:main',\n"
SPINNER_SCRIPT = "            'wheel_spinner = day6_publisher.wheel_spinner:main',\n"


def heredoc(path: str, text: str) -> str:
    """The line by which a student without an editor writes a file."""
    return f"cat > {path} << 'END'\n{text}END\n"
