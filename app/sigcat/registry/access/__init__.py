"""Questions and changes of commands in, the answers of a registry out.

`access` has what can be asked; `local` answers from a database, `remote` asks a service.
"""
