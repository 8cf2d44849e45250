"""The build workspace: `ros2 pkg create`, `colcon`, what sourcing changes, and the export of packages.

A build runs the student's own `setup.py` in a child process and leaves the trees that the real colcon leaves, in the same
places; the generated `install/setup.*` files work in real shells. Only `command`, the program that terminals start, knows
sessions and terminals. `ros2`, which creates packages, and the shell, which sources them, import this. Console texts are those
of colcon-core 0.21 with colcon-ros 0.5.
"""
