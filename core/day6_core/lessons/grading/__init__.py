"""`day6-tui grade`: runs the programs of submissions again, on hidden scenarios, and believes nothing that they claim.

`archive` reads hostile zips, `scenarios` the files that say what is played, `stage` plays it, `judge` is the process that does
so for one submission, `shield` keeps it and what it starts apart and inside its limits, `grader` runs many of them, `reports`
writes tables, `command` is the command.
"""
