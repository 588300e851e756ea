"""The plan of a core in, its header and source in C out: one file for each section of docs/reference/adapter.md."""
