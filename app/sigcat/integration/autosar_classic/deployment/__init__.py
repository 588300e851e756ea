"""The deployment file in; its section on AUTOSAR Classic out.

Settings of the end-to-end state machine have a separate file.
"""
