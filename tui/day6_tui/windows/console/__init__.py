"""rqt_console's window."""
