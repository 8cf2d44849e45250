"""`ros2 node …`."""

SUMMARY = "Various node related sub-commands"
