"""`day6-tui wheelhouse DIR`: everything to be installed without internet, for the machines of a room, on a USB stick.

`targets` are the kinds of machines, `closure` finds what each of them needs and fetches it with pip, `own_wheel` makes the wheel
of the day6-tui that runs, `folder` is the folder on the stick, `guide` what a person reads and runs there. Nothing here imports
Textual.
"""
