# `make serve` and `make test` are all the set-up there is. Everything lands in .venv inside the checkout.

PYTHON ?= python3
BIN := .venv/bin
HOST ?= 127.0.0.1
PORT ?= 8000
RUNS ?= 3

.PHONY: help serve test real format lint types imports tests bench generate pictures kpi clients fuzz slow trust sbom audit package lock clean run-autosar run-ros2 ros2

help:  ## list the commands
	@grep -hE '^[a-z0-9-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 12

serve: .venv/serve  ## start the service with the shipped trees on http://127.0.0.1:8000
	@$(BIN)/sigcat serve --host $(HOST) --port $(PORT)

test: format lint imports  ## the fast checks: formatting, lint, import directions, types, tests
	@$(MAKE) --no-print-directory --jobs=2 types tests

real: .venv/dev  ## the tests that take longer: every page in a browser, generated code built and run, attacks
	$(BIN)/python scripts/browser.py
	$(BIN)/pytest -n auto -m real

format: .venv/dev
	$(BIN)/ruff format --check .

lint: .venv/dev
	$(BIN)/ruff check .
	$(BIN)/python -m scripts.python_api

types: .venv/dev
	$(BIN)/mypy

imports: .venv/dev
	$(BIN)/lint-imports

tests: .venv/dev
	$(BIN)/python scripts/browser.py
	$(BIN)/pytest -n auto -m "not real"

bench: .venv/dev  ## measure, each figure next to its reference
	$(BIN)/python -m bench

ros2:  ## real ROS 2 Jazzy (without rclcpp) for tests, in .venv-ros2; needs Python 3.11 and a C++ compiler
	@$(PYTHON) -m scripts.ros2_environment

run-autosar: .venv/dev  ## EcoControl as three processes over SOME/IP: generate, build, play the drive, compare with the simulation
	$(BIN)/python -m scripts.run_autosar

run-ros2: .venv/dev ros2  ## EcoControl as ROS 2 nodes in C++ and Python: generate, build, play the drive in lock step, compare with the simulation
	$(BIN)/python -m scripts.run_ros2

kpi: .venv/dev ros2  ## EcoControl on every platform: behaviour, timing, load and effort next to the paper's; the report is in build/kpi
	@mkdir -p build
	$(BIN)/sigcat compare examples/ecocontrol --runs $(RUNS) -o examples/ecocontrol/comparison.json -o build/kpi

pictures: .venv/dev  ## take pictures of every page into docs/pictures
	$(BIN)/python -m scripts.pictures

generate: .venv/dev  ## write all generated files: expected outputs of tests, pages of docs, the OpenAPI document
	$(BIN)/python -m scripts.generate

clients: .venv/dev  ## generate a Python and a TypeScript client, and run the same round trip with each
	$(BIN)/python -m scripts.clients

fuzz: .venv/dev  ## search for failures with random examples, for a long time; each new one is added to tests/found_examples.json
	SIGCAT_FUZZ=500 $(BIN)/pytest -n auto -m property
	SIGCAT_FUZZ=500 $(BIN)/pytest tests/api/test_contract.py tests/catalogue/hosting/test_killed.py
	SIGCAT_FUZZ=500 $(BIN)/pytest -n auto tests/adapter/test_mutated.py
	SIGCAT_FUZZ=500 $(BIN)/pytest tests/adapter/autosar_adaptive/bench/test_hostile.py

slow: .venv/dev  ## every test with all its repetitions, and random examples: each format of whole trees, each page, each bomb at each address
	SIGCAT_SLOW=1 $(BIN)/pytest -n auto

trust: .venv/dev  ## check everything with the third-party reference tools, and write the results into docs/explanation/trust.md
	SIGCAT_SLOW=1 SIGCAT_FUZZ=100 $(BIN)/python -m scripts.trust

sbom: .venv/dev  ## write the bill of materials of the shipped packages to build/sbom.json (CycloneDX)
	$(BIN)/python -m scripts.sbom

package: .venv/dev  ## build the source archive and the wheel into dist/, and check their package pages
	rm -rf dist
	$(BIN)/python -m build --no-isolation --outdir dist
	$(BIN)/twine check --strict dist/*

audit: .venv/dev  ## look for known vulnerabilities in shipped packages; needs the network
	$(BIN)/python -m scripts.audit

COMPILE := pip-compile --quiet --strip-extras --no-header --no-emit-index-url --no-emit-find-links --generate-hashes --no-reuse-hashes --allow-unsafe

lock:  ## pin the newest versions that pyproject.toml allows, with their hashes
	$(PYTHON) -m venv .venv-lock && .venv-lock/bin/pip --quiet install pip-tools
	.venv-lock/bin/$(COMPILE) --upgrade --extra otel --output-file requirements.txt pyproject.toml
	.venv-lock/bin/$(COMPILE) --upgrade --only-build-deps --build-deps-for wheel --build-deps-for editable --output-file requirements-build.txt pyproject.toml
	.venv-lock/bin/$(COMPILE) --extra dev --extra otel --constraint requirements.txt --output-file requirements-dev.txt pyproject.toml
	rm -rf .venv-lock

clean:
	rm -rf .venv .venv-ros2 .mypy_cache .pytest_cache .ruff_cache .hypothesis dist build

.venv/bin/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "sigcat needs Python 3.11 or newer; set PYTHON=python3.12 or so")'
	$(PYTHON) -m venv .venv

INSTALL := $(BIN)/python -m pip --quiet --disable-pip-version-check install

.venv/serve: .venv/bin/python requirements.txt requirements-build.txt pyproject.toml
	$(INSTALL) --require-hashes -r requirements.txt -r requirements-build.txt
	$(INSTALL) --no-deps --no-build-isolation --editable .
	@touch $@

.venv/dev: .venv/serve requirements-dev.txt
	$(INSTALL) --require-hashes -r requirements-dev.txt
	@touch $@
