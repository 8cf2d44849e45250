"""The components of the composition tutorial, and executables that run several of them in one process."""
