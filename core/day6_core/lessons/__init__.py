"""Lessons and drills: files that say what to do, checks that watch the running machine, progress that is kept.

`WRITING.md` is the documentation for teachers. `document` reads the files (`catalogue` finds them), `checks` has the named
checks, `live` what they look at, `stage` plays actions (solutions, wrong answers) on a machine, `rehearsal` proves a
lesson with them, `course` goes through a lesson with a pupil, `progress` keeps how far they are.
"""
