"""What comes in: what was built and recorded on each platform.
What goes out: the report of it, in which everything is judged that must hold.
"""
