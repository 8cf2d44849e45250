"""`ros2 daemon …`."""

SUMMARY = "Various daemon related sub-commands"
