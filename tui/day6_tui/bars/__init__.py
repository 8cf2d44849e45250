"""The lines above and below the desktop."""
