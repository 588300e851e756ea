"""The project that a command is in: `sigcat.toml`, found upwards, in; catalogues, functions, rules and settings out.

Options of the command line come first, then the project, then what sigcat ships.
"""
