# Bumpless: `make run` flies, `make test` proves. Needs Python >= 3.11 and make; the rest goes into .venv.
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
SHELL := /bin/sh
# uv leaves bytecode to Python, and without it each start translates hundreds of files once more: 2 CPU seconds
unexport PYTHONDONTWRITEBYTECODE

PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11 python; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && { echo $$p; break; }; done)
BIN := .venv/bin
PY := $(BIN)/python
UV := $(BIN)/uv pip install --quiet --python $(PY)
NPM := $(PY) hatch_build.py npm
DONE := .venv/.make
TWIN := $(shell find twin paper -name '*.py' -o -name '*.toml')
GENERATED = twin/bumpless/contract/bumpless_pb2.py twin/bumpless/contract/bumpless_pb2.pyi $(wildcard console_web/src/gen/*)

help:  ## what each command does
	@sed -n 's/^\([a-z-]*\):.*##  *\(.*\)/  make \1|\2/p' Makefile | column -t -s '|' 2>/dev/null \
		|| sed -n 's/^\([a-z-]*\):.*##  *\(.*\)/  make \1: \2/p' Makefile

run: $(DONE)/compiled console  ## install what is missing, start server and vehicle, print the address
	@exec $(BIN)/bumpless serve $(ARGS)

test: $(DONE)/compiled $(DONE)/dev console chromium  ## the whole suite, browser included (ARGS="-k docking")
	@$(BIN)/pytest $(ARGS)

check: check-style check-imports check-types check-results check-figures check-console check-containers check-gen check-leaks  ## lint, types, import rules, generated files, containers, leaks

check-style: $(DONE)/dev
	$(BIN)/ruff check --quiet .
	$(BIN)/ruff format --quiet --check .

check-imports: $(DONE)/dev $(DONE)/project
	$(BIN)/lint-imports --no-logo

check-types: $(DONE)/dev $(DONE)/project
	$(BIN)/pyright

check-console: $(DONE)/build
	$(NPM) console_web run check --silent

check-containers: $(DONE)/dev
	$(BIN)/hadolint Dockerfile
	$(NPM) .ci exec --offline -- dclint --max-warnings 0 ../docker-compose.yml

check-results: $(DONE)/dev $(DONE)/project
	@$(PY) -m bumpless_paper.readme_results --check

check-figures: $(DONE)/dev $(DONE)/project
	@$(PY) -m tests.bench.render --check

check-gen: $(DONE)/dev
	@before=$$(cat $(GENERATED) | cksum) && $(MAKE) --no-print-directory gen && \
	after=$$(cat $(GENERATED) | cksum) && if [ "$$before" != "$$after" ]; then \
		echo "The generated files were out of date; they are fresh now: commit them." >&2; exit 1; fi

check-leaks:
	@! git grep -nIF -e '$(CURDIR)/' -- .
	@! git grep -nIE -e '(/home|/Users|/root)/[A-Za-z]' -- . ':!Makefile'
	@! git grep -nIE -e '--(extra-)?index-url|--find-links|--trusted-host|https?://' -- 'requirements*.lock'
	@! git grep -nI -e '"resolved":' -- '*package-lock.json'

gen: $(DONE)/dev  ## generate the contract's Python and TypeScript code
	$(PY) -m grpc_tools.protoc -I twin/bumpless/contract --python_out=twin/bumpless/contract --pyi_out=twin/bumpless/contract bumpless.proto
	PYTHON=$(CURDIR)/$(PY) $(NPM) console_web run gen --silent

MINUTES ?= 10
results: $(DONE)/compiled $(DONE)/dev  ## reproduce the paper and renew the README's results
	$(BIN)/bumpless reproduce --out build/reproduce
	@$(PY) -m bumpless_paper.readme_results build/reproduce/reproduce.json

bench: $(DONE)/compiled $(DONE)/dev $(DONE)/bench console  ## measure every speed beside its peers (ARGS="--check", "--live 1")
	$(PY) -m tests.bench $(ARGS)

bench-live: $(DONE)/compiled $(DONE)/dev console  ## a live node beside a loaded server (MINUTES=10)
	$(PY) -m tests.bench.live_node --minutes $(MINUTES) --streams 5

format: $(DONE)/dev  ## let ruff format and sort imports
	$(BIN)/ruff check --select I --fix .
	$(BIN)/ruff format .

console: $(DONE)/build
	@$(PY) hatch_build.py

chromium:
	@sh tests/infra/chromium.sh

LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header \
	--no-annotate --no-emit-index-url --no-emit-find-links pyproject.toml
lock: $(DONE)/build  ## resolve the dependencies anew (ARGS="--upgrade")
	$(LOCK) $(ARGS) -o requirements.lock
	$(LOCK:pyproject.toml=) $(ARGS) --group build -c requirements.lock -o requirements-build.lock
	$(LOCK) $(ARGS) --extra campaign --group build --group dev -c requirements.lock -c requirements-build.lock -o requirements-dev.lock
	$(LOCK) $(ARGS) --extra bench -c requirements-dev.lock -o requirements-bench.lock

clean:  ## remove everything that was installed, built or cached (recorded data stays)
	rm -rf .venv server/bumpless_server/static server/bumpless_server/static.new console_web/node_modules console_web/dist .ci/node_modules
	rm -rf .pytest_cache .ruff_cache .hypothesis .import_linter_cache dist build
	find twin server paper tests -name __pycache__ -prune -exec rm -rf {} +

# ---- what is installed: one stamp per step, redone when its lock changes -----------------------
$(DONE)/venv:
	@test -n "$(PYTHON)" || { echo "Bumpless needs Python 3.11 or newer; none was found." >&2; exit 1; }
	@echo "Creating .venv with $$($(PYTHON) --version) ..."
	@$(PYTHON) -m venv .venv || { rm -rf .venv; \
		echo "This Python cannot make virtual environments (Debian: apt-get install python3-venv)." >&2; exit 1; }
	@mkdir -p $(DONE) && touch $@

$(DONE)/build: $(DONE)/venv requirements-build.lock
	@echo "Installing the build tools ..."
	@$(PY) -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-build.lock
	@touch $@

$(DONE)/run: $(DONE)/build requirements.lock
	@echo "Installing the Python packages ..."
	@$(UV) --require-hashes -r requirements.lock
	@touch $@

$(DONE)/dev: $(DONE)/run requirements-dev.lock
	@echo "Installing the developers' tools ..."
	@$(UV) --require-hashes -r requirements-dev.lock
	@touch $@

$(DONE)/bench: $(DONE)/run requirements-bench.lock
	@echo "Installing the solvers to compare with ..."
	@$(UV) --require-hashes -r requirements-bench.lock
	@touch $@

$(DONE)/project: $(DONE)/run pyproject.toml
	@BUMPLESS_SKIP_CONSOLE=1 $(UV) --no-deps --no-build-isolation --editable .
	@touch $@

$(DONE)/compiled: $(DONE)/project $(TWIN)
	@echo "Compiling for this processor (once; a minute or two) ..."
	@$(PY) -m bumpless.sim.warm_up missions/docking.yaml
	@touch $@

.PHONY: help run test check check-style check-imports check-types check-console check-containers check-gen \
	check-leaks check-results check-figures gen results bench bench-live format console chromium lock clean
