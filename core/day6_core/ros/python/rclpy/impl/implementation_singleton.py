"""`rclpy_implementation`, the module with the low-level names of rclpy's exceptions and enumerations."""

from rclpy import _rclpy_pybind11 as rclpy_implementation

package = "rclpy"

__all__ = ["rclpy_implementation"]
