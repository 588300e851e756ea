"""Connected functions in; a program in C out that calls them in simulated time.

`driver.c` is the same for all of them; for each function a file binds it to the names of its adapter.
"""
