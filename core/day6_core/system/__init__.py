"""What is asked of the system and has another answer on each: its processes, its memory, what limits them.

Linux answers in /proc, macOS by `ps` and `sysconf`, Windows mostly not. What nobody can tell is None, and the caller does
without it. Knows nothing of the rest of the package.
"""
