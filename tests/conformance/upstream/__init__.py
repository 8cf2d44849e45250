"""The tests of ROS's own packages, run on ours; `__main__.py` says how, a JSON file here is one suite."""
