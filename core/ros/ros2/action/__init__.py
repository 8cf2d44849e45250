"""`ros2 action …`."""

SUMMARY = "Various action related sub-commands"
