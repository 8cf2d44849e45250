"""`ros2 multicast …`: one real UDP packet to or from a group, to see whether a network lets multicast through."""

SUMMARY = "Various multicast related sub-commands"
