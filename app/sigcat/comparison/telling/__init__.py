"""Input: the builds and recordings of each platform.
Output: their report, in which all acceptance criteria are evaluated.
"""
