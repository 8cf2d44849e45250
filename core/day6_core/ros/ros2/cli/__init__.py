"""Shared by all commands of `ros2`: the command tree, options, the command's own node, the daemon, completion.

Imported by the verbs and by the shell (completion); imports no verb by name.
"""
