"""TurtleSim's window."""
