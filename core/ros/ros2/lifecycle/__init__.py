"""`ros2 lifecycle …`."""

SUMMARY = "Various lifecycle related sub-commands"
