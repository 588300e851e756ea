"""What comes in: a set of functions, a folder to build in, and a drive.
What goes out: for each platform what was built, and a recording of what it did while the drive was played to it.
"""
