"""The part of ROS's rosidl_parser that programs use: the classes found in SLOT_TYPES."""
