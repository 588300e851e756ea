"""Which side of a data interface or a method a call is on."""

CONSUMER = "Consumer"
PROVIDER = "Provider"
