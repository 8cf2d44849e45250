"""tf2_tools: `view_frames` is its executable, `frame_tree` the tree that it and rqt_tf_tree draw."""
