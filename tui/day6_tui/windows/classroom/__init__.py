"""The teacher's window."""
