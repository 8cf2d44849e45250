"""Lessons and drills: files that say what to do, checks that watch the running machine, progress that is kept.

`writing/en.md` is the documentation for teachers. `document` reads the files (`catalogue` finds them), `checks` has the named
checks, `live` what they look at, `player` types and waits as it is steered: `stage` plays actions (solutions, wrong answers)
so on a machine, `scene_player` those of `scene` on a desktop. `rehearsal` proves a lesson with them, `lag` tells whether the
machine kept up, `course` goes through a lesson with a pupil, `progress` keeps how far they are.
"""
