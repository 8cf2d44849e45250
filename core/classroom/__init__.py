"""Pupils and their teacher: what a desktop tells of its pupil, and what a teacher may order."""
