"""`ros2 param …`.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

SUMMARY = "Various param related sub-commands"
