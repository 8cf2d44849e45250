"""The executable of tf2_tools."""
