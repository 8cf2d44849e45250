"""What a program of ours runs in: the world clock, the scheduler, and a session with streams, ROS context and windows.

May import `core.graph` and, inside functions, rclpy. Knows nothing of shells and terminals, which build on it.
"""
