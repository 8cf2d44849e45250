"""The executables of tf2_ros."""
