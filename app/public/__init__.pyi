# The types of `import sigcat`, in the wheel as sigcat/__init__.pyi. Within the package they would make one import cycle of all modules,
# in which mypy no longer resolves types.
from sigcat.catalogue.comparing.changes import AttributeChange as AttributeChange
from sigcat.catalogue.comparing.changes import Change as Change
from sigcat.catalogue.reading.statement import Origin as Origin
from sigcat.errors import InputRefused as InputRefused
from sigcat.errors import NotFound as NotFound
from sigcat.errors import SigcatError as SigcatError
from sigcat.errors import UsageError as UsageError
from sigcat.findings import Finding as Finding
from sigcat.function.node_uses import NodeUse as NodeUse
from sigcat.python_api.catalogue import Catalogue as Catalogue
from sigcat.python_api.catalogue import Trial as Trial
from sigcat.python_api.catalogue import diff as diff
from sigcat.python_api.catalogue import open_catalogue as open_catalogue
from sigcat.python_api.function import Function as Function
from sigcat.python_api.node import Attribute as Attribute
from sigcat.python_api.node import Node as Node
from sigcat.python_api.project import Project as Project
from sigcat.python_api.project import open_project as open_project
from sigcat.python_api.rows import Row as Row
from sigcat.python_api.run import Run as Run
from sigcat.python_api.run import simulate as simulate

__version__: str
