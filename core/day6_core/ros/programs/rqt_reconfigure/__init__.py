"""rqt_reconfigure 1.6 (Jazzy), the Parameter Reconfigure plugin.

`ranges` steps through what a descriptor allows, `values` reads and writes values as text, `opened` is one node whose parameters
are shown, `model` is what the window reads, `rqt_reconfigure` is the program.
"""
