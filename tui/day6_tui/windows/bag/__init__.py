"""rqt_bag's window."""
