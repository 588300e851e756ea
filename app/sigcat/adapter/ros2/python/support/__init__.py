"""Code that the nodes of all functions share; the same in every package that sigcat writes."""
