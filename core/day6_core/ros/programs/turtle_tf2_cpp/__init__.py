"""The programs of the tf2 tutorials that real ROS has in C++; most are those of turtle_tf2_py."""
