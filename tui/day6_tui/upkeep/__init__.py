"""`day6-tui doctor` and `day6-tui uninstall`: what a bug report needs, checked, and how to be rid of everything.

Both look at the tables of `day6_core.places` and `day6_core.variables`, at what runs, and at how day6-tui was installed.
"""
