"""In: the course of a drive, written in these files. Out: the recorded drives of the examples, as CSV.

They are made of +, -, *, / and square roots alone, which every machine rounds alike.
"""
