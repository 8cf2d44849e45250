"""Windows of camera images."""
