"""Connected functions with their sources in; a program that runs them, or what the compiler says of them, out.

Everything is compiled in a separate folder, and nothing is written beside the sources.
"""
