"""turtlesim: its four executables, each an `async def main(session)`, and in `model` the turtles without ROS.

The executables import what a ROS user could import and the model; the TurtleSim window imports the model alone.
"""
