"""Input: a file of scenarios, and a trace.
Output: drives with faults, the same for every platform, and the values that were sent in the time of each scenario.
"""
