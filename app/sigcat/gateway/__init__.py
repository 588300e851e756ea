"""A CAN database, a catalogue with mappings, and frames of a log or a bus come in.
Values of signals at their times go out: into a trace, over SOME/IP or over DDS; and what was left out, counted.
"""
