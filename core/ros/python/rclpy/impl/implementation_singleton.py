"""`rclpy_implementation`: where rclpy's exceptions and enumerations are reached by their low-level names."""

from rclpy import _rclpy_pybind11 as rclpy_implementation

package = "rclpy"

__all__ = ["rclpy_implementation"]
