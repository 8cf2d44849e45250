"""`ros2 node …`.

Each public module is a verb, imported by the command tree only (see `ros2`).
"""

SUMMARY = "Various node related sub-commands"
