"""Limits of input: how much is read, how much work one input may cause before it is refused, how much a page shows of it.

What a caller may set is a field of `Limits`, `FetchLimits` or `ArchiveLimits`; the rest are constants. Limits of the
service, such as the size of a body, are its settings (`api/settings.py`). `make generate` writes the page of limits from
this file.
"""

from typing import NamedTuple


class Limits(NamedTuple):
    """Bounds on input. The defaults are far above any real tree and far below what would hurt the process."""

    file_bytes: int = 32 * 1024 * 1024
    """Bytes of one file."""
    nesting: int = 64
    """Levels of YAML collections inside each other (VSS needs four)."""
    values: int = 2_000_000
    """Values in one file, with every alias counted as often as it is used."""
    files: int = 10_000
    """Files that one tree may include, a file counted as often as it is included."""
    nodes: int = 1_000_000
    """Nodes of a tree after the expansion of instances."""
    path_names: int = 64
    """Names in one path."""
    compared: int = 1_000_000_000
    """Characters of paths that the wildcard paths of one layer, such as `Vehicle.*.Speed`, are compared with."""
    pattern_seconds: float = 10.0
    """Processor seconds for the patterns of one tree, all together; those left after that are not checked, and a finding says so."""


DEFAULT_LIMITS = Limits()


class FetchLimits(NamedTuple):
    """Bounds on one download, as of `sigcat pull`."""

    bytes: int = 128 * 1024 * 1024
    """Bytes of a download."""
    idle_seconds: float = 20.0
    """Seconds without a byte."""
    total_seconds: float = 600.0
    """Seconds of a whole download."""
    redirects: int = 5
    """Redirects that a download follows."""


DEFAULT_FETCH_LIMITS = FetchLimits()


class ArchiveLimits(NamedTuple):
    """Bounds on what an archive may hold; an official release has about 1,000 files and 20 MB."""

    entries: int = 20_000
    """Files and folders in an archive."""
    unpacked_bytes: int = 512 * 1024 * 1024
    """Bytes that an archive unpacks to."""
    file_bytes: int = 32 * 1024 * 1024
    """Bytes of one file that is kept."""
    ratio: int = 200
    """Times that an archive may grow when it is unpacked, beyond what any archive may."""
    free_bytes: int = 16 * 1024 * 1024
    """Bytes that any archive may unpack to, however small it is."""
    path_characters: int = 240
    """Characters of a path in an archive."""
    path_names: int = 32
    """Names in a path in an archive."""


DEFAULT_ARCHIVE_LIMITS = ArchiveLimits()

# -- files ----------------------------------------------------------------------------------------------------------

CONFIGURATION_BYTES = 1024 * 1024
"""Bytes of `sigcat.toml`."""

VEHICLES = 1_000
"""Vehicles of a project, each of their states counted."""

COMPILER_WARNINGS = 20
"""Warnings of the compiler that a simulation reports."""
INSTANCE_ROWS = 1_000
"""Rows that a vehicle gives the instances of a branch."""

RECOGNITION_BYTES = 4 * 1024 * 1024
"""Bytes of a YAML or JSON file that are looked into to find out what it is, where its name does not say so."""

NUMBER_CHARACTERS = 1_000
"""Characters of one number in YAML: reading a longer one takes time that grows with the square of its length."""

REFUSED_INCLUDES = 100
"""Includes of a posted text that are refused one by one; of more, their number is given."""

PATTERN_MATCH_SECONDS = 0.1
"""Seconds of one match of a regular expression of others, such as that of a company's rule."""

PATTERN_PARTS = 10_000
"""Parts of a regular expression with its repetitions written out: what is larger takes seconds to compile."""

COMPARED_INSTANCES = 100_000
"""Instances on one level that a rule compares with names; composing refuses a tree of so many."""

# -- functions ------------------------------------------------------------------------------------------------------

FUNCTION_COLLECTIONS = 200_000
"""Lists and mappings in one function file: twenty times those of a function with 10,000 signals."""

FUNCTION_PROBLEMS = 1_000
"""Wrong values that are reported one by one for a function file; of more, their number is given."""

EXPRESSION_CHARACTERS = 1_000
"""Characters of a C expression that a value is held in (`variable`)."""

FORMULA_CHARACTERS = 1_000
"""Characters of a formula that a network's value is converted with (`math`)."""

FORMULA_DEPTH = 64
"""Parentheses, signs and operators inside each other in a formula."""

# -- C code that is imported -------------------------------------------------------------------------------------------

CODE_FILES = 2_000
"""Files of C code in a folder; a generated model has some dozen."""

CODE_FILE_BYTES = 16 * 1024 * 1024
"""Bytes of one file of C code; a larger one is left out."""

CODE_BYTES = 64 * 1024 * 1024
"""Bytes of C code that are read of a folder."""

CODE_SECONDS = 60
"""Seconds in which a folder of C code has to be parsed, whatever its macros expand to."""

CODE_MEGABYTES = 2_048
"""Megabytes of memory that the parser of C code may take."""

CODE_VALUES = 2_000
"""Inputs, outputs and parameters that are imported of one model; elements of an array count once."""

# -- runs -----------------------------------------------------------------------------------------------------------

HOSTED_FUNCTION_BYTES = 4 * 1024 * 1024
"""Bytes of a function file in a folder of the service; a larger one is skipped, and `/health/ready` names it."""

QUEUE_LENGTH = 65_535
"""Values that a queue of a function may hold."""

TRACE_ROW_BYTES = 4 * 1024 * 1024
"""Bytes of one row of a trace."""

TRACE_FINDINGS = 100
"""Findings in one trace; after that it is not read on."""

RUN_CALLS = 10_000_000
"""Cyclic calls in one simulation: a day of a function that runs every 10 ms has 8.6 million."""

LOG_LINE_BYTES = 64 * 1024
"""Bytes of one line of a CAN log; a longer one is left out."""

LOG_CONTAINER_BYTES = 32 * 1024 * 1024
"""Bytes that one container of a BLF log may have, packed or unpacked; tools write containers of 128 KiB."""

LOG_FINDINGS = 100
"""Lines of a CAN log that are not frames and are reported one by one; further ones are counted."""

LOG_IDENTIFIERS = 10_000
"""Identifiers of frames that are counted one by one; those of others together."""

RUN_BYTES = 16 * 1024 * 1024
"""Bytes of a stored run that a page draws; ten minutes of EcoControl have 0.7 MB."""

COMPARISON_BYTES = 8 * 1024 * 1024
"""Bytes of a stored comparison that a page shows; that of EcoControl has less than 1 MB."""

RUN_HEADER_BYTES = 256 * 1024
"""Bytes of the first row of a CSV file in a folder of functions, by which a run is known."""

RUNS = 200
"""Stored runs of one folder of functions, in the order of their names; those after them are left out."""

RUN_SIGNALS = 8
"""Signals in one picture of a run."""

RUN_STATUSES = 100
"""Errors, safety reactions and modes in one picture of a run."""

RUN_CHANGES = 20
"""Changes of one of them that a page lists."""

RUN_GAPS = 1_000
"""Passed time-outs of a signal that a picture shows."""

# -- registry ---------------------------------------------------------------------------------------------------------

REGISTRY_ROWS = 1_000
"""Rows of an answer of the registry, such as users of a path; of more, their number is given."""

REGISTRY_SECONDS = 60
"""Seconds for which a command waits until others have written to the registry."""

REGISTRY_REQUEST_SECONDS = 5
"""Seconds for which the service waits until others have written to the registry; then the request is answered with 503."""

EVENT_SECONDS = 60
"""Seconds for which a request may wait for an event of the registry."""

EVENT_WAITS = 200
"""Requests that wait for events of the registry at once, in one process of the service."""

SESSION_SECONDS = 8 * 60 * 60
"""Seconds until a person has to sign in to the pages of the registry again."""

WEBHOOK_SECONDS = 10
"""Seconds for which a webhook waits for an answer."""

WEBHOOK_ATTEMPTS = 12
"""Attempts to deliver an event to a webhook, within one to two days."""

REGISTRY_ANSWER_BYTES = 256 * 1024 * 1024
"""Bytes of an answer of a registry over HTTP; a longer one is refused."""

# -- requests and pages ---------------------------------------------------------------------------------------------

NAME_CHARACTERS = 300
"""Characters of a name in a request: of a catalogue, a rule, a file."""

PARAMETER_CHARACTERS = 2_000
"""Characters of one parameter of a request, such as the path of a node."""

BASKET_CHARACTERS = 6_000
"""Characters of all paths in the basket: they are in the address of every page."""

BASKET_SIGNALS = 2_000
"""Signals of a basket that are written as an overlay or a function."""

PARAMETER_VALUES = 1_000
"""Values of a parameter that may be given several times."""

REQUEST_FUNCTIONS = 500
"""Functions in one request to the API."""

PAGE_FUNCTIONS = 20
"""Functions of a set that a page shows."""

PAGE_FINDINGS = 200
"""Findings, or nodes that an overlay changes, that a page lists; of more, their number is given."""

PAGE_TEXT_CHARACTERS = 256 * 1024
"""Characters of a text that a page shows whole; of a longer one, it shows the lines with findings."""

PAGE_LINES = 5_000
"""Lines of such a text."""

PAGE_CHANGES = 1_000
"""Changes between two trees that a page lists, the worst first."""

PICTURED_NODES = 50_000
"""Nodes of a catalogue whose page has a picture of it."""

SEARCH_WORDS = 32
"""Words of a text to search for; a generated name counts as the words that it is made of."""

FORM_FIELDS = 40
"""Fields of a form, and files of it; no page has as many."""

ANSWER_DEPTH = 64
"""Levels below a node in one answer of the API."""

ANSWER_FINDINGS = 1_000
"""Findings in one answer of the API; a hostile text can have as many as it has lines."""

# -- proposals ("Did you mean …?") ----------------------------------------------------------------------------------

COMPARED_NAMES = 1_000_000
"""Names that are compared for proposals in one file, layer, or piece of work of the service: about a second. Later ones get none: with so many wrong names, another tree was meant."""

PROPOSAL_CHARACTERS = 500
"""Characters of a name that is compared with others for a proposal."""

ASSISTANT_CHARACTERS = 40_000
"""Characters of a list in an answer to an assistant; the answer says how many entries are omitted."""

ASSISTANT_ITEMS = 100
"""Entries of a list in an answer to an assistant."""

ASSISTANT_TEXT = 500
"""Characters of a text in an answer to an assistant; longer ones are cut."""
