"""Types as ROS checks them."""
