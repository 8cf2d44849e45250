"""The parts of ros2cli that programs import: nodes for questions about the graph, the daemon, extensions, helpers.

`ros2topic`, `ros2node` … beside it have the functions of the real packages of these names. Their verbs, `ros2topic.verb.echo`,
are modules made at their import (`made_modules`) around those of `day6_core.ros.ros2`, which the command `ros2` runs.
"""
