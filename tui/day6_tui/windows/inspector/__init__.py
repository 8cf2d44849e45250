"""The inspector's window."""
