"""Keeps the pupils of one machine apart: their files, their processes, and what each may take of the machine.

`modes.survey` tries which ways this machine has, best first; `cell.Cell` says what one pupil gets; a mode's `command` starts a
program in the cell and its `end` leaves nothing of it. Nothing here knows what runs in a cell. Only the standard library and
`core.whole_file` are imported; all of it works on Linux only, elsewhere there is the mode that separates nothing.
"""
