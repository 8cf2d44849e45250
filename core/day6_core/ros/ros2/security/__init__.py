"""`ros2 security …`: keys and policies for DDS. Nothing here can be encrypted, so every verb refuses.

Each public module is a verb, imported by the command tree only (see `ros2`); modules with an underscore are shared by
them.
"""

SUMMARY = "Various security related sub-commands"
