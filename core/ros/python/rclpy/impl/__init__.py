"""The parts of rclpy that are not meant for programs, under the names some of them use nevertheless."""
