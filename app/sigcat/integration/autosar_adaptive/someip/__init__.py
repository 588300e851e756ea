"""Services in; their SOME/IP ids, versions and segments out.

Ids of the deployment precede those of a catalogue and those by rule.
"""
