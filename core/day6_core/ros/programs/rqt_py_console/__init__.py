"""rqt_py_console 1.2 (Jazzy): `model` is what the window reads, `rqt_py_console` the program, `interpreter` its Python."""
