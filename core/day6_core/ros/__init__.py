"""The contents of a ROS installation, laid out as in /opt/ros.

`python/` is put on `sys.path` of every program (rclpy, the message packages); it is never imported as a sub-package of this
one. `share/` has interface texts and package manifests, `programs/` the executables of our packages, `ros2/` the `ros2`
command. What only some distributions have is in `python_of/` and `share_of/`, a folder for each.

These are in several layers. The modules here are below all of them: `distribution` (the one chosen), `differences` (the table of
what differs, with its sources), `program_index` (the existing executables and commands), `executables` (the commands as real
files), `left_out` (C++ that a build left out) and `environment` (the paths of all this, and the variables of a ROS program).
`ros2` may import the programs, and both may import `python/`.
"""
