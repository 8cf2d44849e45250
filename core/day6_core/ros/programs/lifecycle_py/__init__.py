"""The managed talker of real ROS's package lifecycle_py."""
