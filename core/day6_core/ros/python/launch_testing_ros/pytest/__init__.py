"""The pytest plugin of launch_testing_ros."""
