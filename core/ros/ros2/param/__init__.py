"""`ros2 param …`."""

SUMMARY = "Various param related sub-commands"
