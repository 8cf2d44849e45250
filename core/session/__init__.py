"""What a program of ours runs in: the world clock, the scheduler, and a session with streams, ROS context and windows.

`session.Session` is what a program gets, `task` what it waits with, `scheduler` what runs it, `local` the same in a real
terminal; `signals` and `guardian` are about real processes. May import `core.graph` and, inside functions, rclpy. Knows nothing
of shells and terminals, which build on it.
"""
