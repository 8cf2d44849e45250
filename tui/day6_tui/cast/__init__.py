"""Recordings of the screen as asciinema casts, version 2.

`recorder` writes them, `file` reads them, `film` knows the picture at any time, `svg` draws it, `player` plays it in a terminal,
`command` is `day6-tui cast`. Nothing of a file reaches the terminal as it is: it is fed to the emulation that our own terminals
have, and what that shows is drawn.
"""
