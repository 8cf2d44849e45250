"""rqt_plot: numbers over time. `_field` finds them in messages, `_model` keeps them, `_axis` and `_lines` are for drawing."""
