"""The OpenAPI document, from which clients are generated."""

import subprocess
import sys

from tests.api.conftest import Ask


def test_operation_ids_read_as_function_names(ask: Ask) -> None:
    paths = ask("/openapi.json").json()["paths"]
    ids = [operation["operationId"] for methods in paths.values() for operation in methods.values()]
    assert {"list_catalogues", "get_node", "get_tree", "search_nodes", "list_units"} <= set(ids)
    assert len(ids) == len(set(ids))
    assert all(each.isidentifier() for each in ids)


def test_one_schema_stands_for_each_noun(ask: Ask) -> None:
    schemas = ask("/openapi.json").json()["components"]["schemas"]
    assert not [name for name in schemas if "__" in name or name.endswith(("-Input", "-Output"))]


def test_linting_does_not_load_the_service() -> None:
    code = "import sys, app.rules, app.catalogue.compose; print('fastapi' in sys.modules, 'app.api' in sys.modules)"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.split() == ["False", "False"]
