"""teleop_twist_keyboard 2.4.0 (Jazzy): drives whatever listens on cmd_vel with the keys around `k`."""
