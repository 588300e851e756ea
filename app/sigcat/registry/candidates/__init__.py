"""Files to publish in, versions that may be published out: read, resolved and checked against their catalogue.

`catalogue_files` makes one document of a catalogue, from which a service composes it.
"""
