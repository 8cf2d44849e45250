"""`ros2 lifecycle …`.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

SUMMARY = "Various lifecycle related sub-commands"
