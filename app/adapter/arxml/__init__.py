"""ARXML for AUTOSAR adaptive."""
