"""The editor's window."""
