"""rqt_shell 1.2 (Jazzy): `model` is what the window reads, `rqt_shell` is the program."""
