"""CAN database, mappings and the variables of an FMU in; its bus in Integration JSON and the tables of it in C out.

`c` has the codec, which is the same in every FMU with a bus.
"""
