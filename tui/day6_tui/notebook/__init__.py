"""`%load_ext day6_tui`: cells of a notebook are ROS programs, as `day6-tui python FILE` makes one of a file.

`extension` watches the cells and says what became of their nodes, `spinner` spins one node in a thread of its own,
`init_in_cells` lets a cell be run again, `ros2_line` is `%ros2`, `errors` shows what failed as IPython does, `shell` is what is
used of IPython. What differs from a program: rclpy.init installs no signal handlers (the kernel's interrupt stays a
KeyboardInterrupt, and ROS goes on), nodes go on after their cell, and a node that a cell makes again takes the place of the one
it made before.
"""
