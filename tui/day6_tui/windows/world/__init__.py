"""The simulated world's window."""
