"""The schedule of a function: order, times and supervision of calls."""
