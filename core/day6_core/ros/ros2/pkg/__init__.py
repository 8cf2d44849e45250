"""`ros2 pkg …`.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

SUMMARY = "Various package related sub-commands"
