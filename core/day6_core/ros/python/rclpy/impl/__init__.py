"""The parts of rclpy that are not meant for programs, although some import them."""
