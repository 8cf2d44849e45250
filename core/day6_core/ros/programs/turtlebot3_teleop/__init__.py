"""turtlebot3_teleop 2.3.6: drives a robot like the TurtleBot3, whose speed grows in small steps."""
