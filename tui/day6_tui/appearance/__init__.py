"""How it all looks: language, theme, characters; one object that all panes share."""
