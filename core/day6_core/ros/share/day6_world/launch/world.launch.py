"""A robot in a world: `ros2 launch day6_world world.launch.py world:=walls robot:=FILE.urdf`.

As with Gazebo, robot_state_publisher hands the description to the world and turns joint states into /tf, and everybody
goes by the world's clock.
"""

import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node

from day6_urdf import shipped_model

ARGUMENTS = (
    ("world", "empty", "empty, walls, maze, line, or a world file"),
    ("robot", str(shipped_model("day6_bot_gazebo")), "the URDF or xacro file of the robot"),
    ("use_sim_time", "true", "go by the world's clock"),
    ("seed", "0", "the same number gives the same noise"),
    ("speed", "1.0", "how fast the world's time passes"),
    ("stamped", "false", "hear TwistStamped on /cmd_vel, as the TurtleBot3 does"),
    ("follow_joint_states", "false", "the wheels do what others say on /joint_states"),
)


def nodes(context):
    value = {name: LaunchConfiguration(name).perform(context) for name, _, _ in ARGUMENTS}
    robot = os.path.expanduser(value["robot"])
    if robot.endswith(".xacro"):
        description = Command(["xacro ", f"'{robot}'"]).perform(context)
    else:
        with open(robot, encoding="utf-8") as file:
            description = file.read()
    use_sim_time = value["use_sim_time"].lower() == "true"
    return [
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            parameters=[{"robot_description": description, "use_sim_time": use_sim_time}],
        ),
        Node(
            package="day6_world",
            executable="world",
            output="screen",
            parameters=[
                {
                    "world": value["world"],
                    "seed": int(value["seed"]),
                    "speed": float(value["speed"]),
                    "stamped": value["stamped"].lower() == "true",
                    "follow_joint_states": value["follow_joint_states"].lower() == "true",
                }
            ],
        ),
    ]


def generate_launch_description():
    declared = [
        DeclareLaunchArgument(name, default_value=default, description=about) for name, default, about in ARGUMENTS
    ]
    return LaunchDescription([*declared, OpaqueFunction(function=nodes)])
