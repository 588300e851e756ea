"""A run and a file of expected outputs in; what differs, as findings, a table, a picture and a JUnit report, out."""
