"""`ros2 daemon …`.

Each public module is a verb, imported by the command tree only (see `ros2`).
"""

SUMMARY = "Various daemon related sub-commands"
