"""rqt_srv: browses service types; `rqt_srv` is the program, its model is that of rqt_msg."""
