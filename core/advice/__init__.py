"""Hints for beginners below the errors of Python, launch and colcon, in the user's language; the errors stay as they are.

A hint is given only where the fault is certain: a wrong one costs a beginner more than none. The shell and colcon use this, on
terminals only; it imports nothing above the interfaces.
"""
