"""The desktop in the terminal: panes for terminals and windows, drawn from the models that `core` owns.

Everything here may import `day6_tui.core` and Textual; nothing outside may import this. A pane owns no state of its
model: it reads a snapshot on the one frame timer (`frames`) and refreshes the cells that changed.
"""
