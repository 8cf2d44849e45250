"""The drills, one Markdown file for each fault; a `check_….py` decides what the named checks cannot say.

Those are run like a pupil's programs (`python3 FILE`), never imported.
"""
