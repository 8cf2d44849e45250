"""The executables of dummy_sensors: what a robot would measure, if there were one."""
