"""`ros2 pkg …`."""

SUMMARY = "Various package related sub-commands"
