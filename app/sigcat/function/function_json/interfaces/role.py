"""Side of a data interface or a method on which a call is."""

CONSUMER = "Consumer"
PROVIDER = "Provider"
