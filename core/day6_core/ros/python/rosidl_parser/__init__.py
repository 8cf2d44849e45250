"""The part of ROS's rosidl_parser that programs use: the classes in SLOT_TYPES."""
