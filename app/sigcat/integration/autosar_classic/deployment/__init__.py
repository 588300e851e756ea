"""The deployment file in; its section on AUTOSAR Classic out.

The state machine of end-to-end protection has settings of its own.
"""
