"""What comes in: a file of scenarios, and a trace.
What goes out: drives with faults in them, the same for every platform, and what was sent in the time of each scenario.
"""
