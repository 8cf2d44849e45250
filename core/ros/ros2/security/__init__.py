"""`ros2 security …`: keys and policies for DDS. Nothing here can be encrypted, so every verb says that it cannot."""

SUMMARY = "Various security related sub-commands"
