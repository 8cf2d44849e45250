"""rqt_tf_tree: the tree of frames. `model` is what the window reads, `rqt_tf_tree` is the program."""
