"""The inspector."""

TEXTS = {
    "inspector.title": "Inspector",
    "inspector.count": "{errors} errors, {all} in all",
    "inspector.count.one": "{errors} error, {all} in all",
    "inspector.quiet": "quiet",
    "action.inspector": "Inspect",
    "help.action.inspector": "what is wrong right now, and what to type next",
    "help.inspector": (
        "What is wrong right now: in the graph (names that differ by a letter, types and QoS that do not match, two publishers "
        "that fight, joints the robot does not have), in the terminals (nothing sourced or built, what a program failed of), "
        "in the files (changed and not built again, what setup.py lacks), and inside programs (nobody spins, a callback that "
        "does not come back).\n\nRed keeps something from working. The line below is a command that helps: Enter, or a click, "
        "writes it into a terminal, where another Enter runs it.\n\nThe inspector only looks on: it is in no list and no count. "
        "In a drill and in an exam it is quiet until the fault is mended or given up."
    ),
}
