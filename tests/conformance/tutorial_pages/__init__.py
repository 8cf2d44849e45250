"""Plays the pages of the official tutorials; `__main__.py` is the command. Names of its own: several folders of tests share a process."""
