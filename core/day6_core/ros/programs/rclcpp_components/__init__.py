"""Containers, into which `ros2 component load` and launch files put nodes while they run."""
