"""What a ROS installation provides, laid out as people know it from /opt/ros.

`python/` goes on `sys.path` of every program (rclpy, the message packages); it is never imported as a sub-package of this one.
`share/` holds interface texts and package manifests, `programs/` the executables of our packages, `ros2/` the `ros2` command.
"""
