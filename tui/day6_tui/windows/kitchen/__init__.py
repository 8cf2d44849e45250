"""The kitchen's window."""
