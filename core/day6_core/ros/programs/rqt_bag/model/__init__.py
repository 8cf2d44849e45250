"""What rqt_bag knows of its bags: the index (timeline), the playhead and what it publishes, recording, export, pictures."""
