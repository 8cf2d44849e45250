"""A small flat world in which a robot's wheels roll: walls, a line on the floor, a lidar. Not part of real ROS 2.

It takes the place of Gazebo in a real lesson: same topics, same demands on the URDF, its own simulated time.
"""
