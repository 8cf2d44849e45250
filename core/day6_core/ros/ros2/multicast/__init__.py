"""`ros2 multicast …`: one real UDP packet to or from a group, which shows whether a network passes multicast.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

SUMMARY = "Various multicast related sub-commands"
