"""The command xacro: the macro language of robot descriptions (PyPI's `xacro`, 2.1)."""
