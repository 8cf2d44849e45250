"""Messages as trees of fields, shown and filled in."""
