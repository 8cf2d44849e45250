"""`day6-tui grade`: runs the programs of submissions again, on hidden scenarios, and believes nothing that they claim.

`archive` reads hostile zips, `scenarios` the files that say what is played, `stage` plays it, `judge` is the process that does
so for one submission, `shield` keeps it and what it starts apart and inside its limits, `lessons.lag` tells whether the machine
kept up, `marks` what that is worth. `grader` runs many of them, `grades` is what is known then, `remarks` are the teacher's
words, and `reports` writes tables of both; `command` is the command.
"""
