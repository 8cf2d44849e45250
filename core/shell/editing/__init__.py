"""The editor behind nano, gedit, vim and code: the file on the disk, what is wrong in a text, the model of the window."""
