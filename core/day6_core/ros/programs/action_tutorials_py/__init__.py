"""The server and client of the action tutorial, as real ROS has them in Python."""
