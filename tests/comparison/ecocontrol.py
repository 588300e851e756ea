"""EcoControl, as it is compared."""

from functools import cache
from pathlib import Path

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.comparison.running.runner import Subject
from sigcat.integration.reading import read_functions
from sigcat.platforms.deployment_file import read_deployment
from sigcat.runs.prepare import prepare

EXAMPLES = Path(__file__).parents[2] / "examples"
DRIVE = EXAMPLES / "ecocontrol/drive.csv"


@cache
def subject(names: tuple[str, ...] = ("core_acc", "eco_control_mpc")) -> Subject:
    """Both functions, in an order, and their deployment."""
    paths = [EXAMPLES / name / "function.yaml" for name in names]
    deployment = EXAMPLES / "ecocontrol/deployment.yaml"
    functions, _ = read_functions([(path.read_bytes(), str(path)) for path in paths], load(shipped_sources()[0]))
    return Subject(functions, prepare(functions), read_deployment(deployment.read_bytes(), str(deployment)))
