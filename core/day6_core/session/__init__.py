"""What our own programs run in: the world clock, the scheduler, and a session with streams, ROS context and windows.

A program gets a `session.Session`, waits with `task`, is run by `scheduler` (by `local` in a real terminal) and reads its
command line with `argument_parser`; `signals` is about real processes. May import rclpy (inside
functions, for programs without a node), `day6_core.link` and whatever those import. Knows nothing about launch, programs, shells
and terminals.
"""
