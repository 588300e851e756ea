"""What the nodes of all functions have in common; the same in every package that sigcat writes."""
