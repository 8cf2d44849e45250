"""What rclpy is made of here; the modules beside this folder are those that the real rclpy has, and what they share is in it."""
