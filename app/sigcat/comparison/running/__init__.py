"""Input: a set of functions, a folder to build in, and a drive.
Output: for each platform its build, and a recording of the drive that was played to it.
"""
