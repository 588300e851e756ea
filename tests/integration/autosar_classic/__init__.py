"""Functions become the Integration JSON of AUTOSAR Classic."""
