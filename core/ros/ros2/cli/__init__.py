"""What the commands of `ros2` share: the parser, the command tree, options, the command's own node, the daemon."""
