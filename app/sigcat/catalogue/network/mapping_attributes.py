"""Attributes of a signal that map it to one of a network."""

PROFILE, KUKSA, KUKSA_ALIAS, KUKSA_TARGET = "network_serialization", "dbc2vss", "dbc", "vss2dbc"
RECEIVED = (PROFILE, KUKSA, KUKSA_ALIAS)
"""Attributes that say what a signal is received from."""
ATTRIBUTES = (*RECEIVED, KUKSA_TARGET)
"""Attributes that map a signal."""
