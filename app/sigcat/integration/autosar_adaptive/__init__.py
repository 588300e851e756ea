"""AUTOSAR adaptive: components, executables and service interfaces, derived from functions."""
