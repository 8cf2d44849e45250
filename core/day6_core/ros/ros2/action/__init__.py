"""`ros2 action …`.

Each public module is a verb, imported by the command tree only (see `ros2`).
"""

SUMMARY = "Various action related sub-commands"
