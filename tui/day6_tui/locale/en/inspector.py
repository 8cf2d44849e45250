"""The inspector."""

TEXTS = {
    "inspector.title": "Inspector",
    "inspector.count": "{errors} errors, {all} in all",
    "inspector.count.one": "{errors} error, {all} in all",
    "inspector.quiet": "quiet",
    "action.inspector": "Inspect",
    "help.action.inspector": "what is wrong right now, and what to type next",
    "help.inspector": (
        "What is wrong right now: in the graph (names one letter apart, types or QoS that do not match, two publishers "
        "fighting over a topic, joints the robot doesn't have), in the terminals (nothing sourced or built, why a program "
        "failed), in the files (changed but not rebuilt, things missing from setup.py), and inside programs (nothing "
        "spins, a callback that never returns).\n\n"
        "Red means that something cannot work. The line below is a command that helps: Enter, or a click, writes it into a "
        "terminal, where another Enter runs it.\n\n"
        "The inspector only watches: it appears in no list and no count. In drills and exams it stays quiet until you fix "
        "the bug or give up."
    ),
}
