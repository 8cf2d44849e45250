"""What rqt's plugins share, as in ROS: `expressions` are typed into fields, `message_form` is the tree of a message's fields,
`command_lines` are typed and print."""
