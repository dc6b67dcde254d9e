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
CORES := $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
TWIN := $(shell find twin paper -name '*.py' -o -name '*.toml')
GENERATED = twin/bumpless/contract/bumpless_pb2.py twin/bumpless/contract/bumpless_pb2.pyi $(wildcard console_web/src/gen/*)

help:  ## what each command does
	@sed -n 's/^\([a-z-]*\):.*##  *\(.*\)/  make \1|\2/p' Makefile | column -t -s '|' 2>/dev/null \
		|| sed -n 's/^\([a-z-]*\):.*##  *\(.*\)/  make \1: \2/p' Makefile

run: ready  ## install what is missing, start server and vehicle, print the address
	@exec $(BIN)/bumpless serve $(ARGS)

# the console is built while the control code compiles: on a fresh machine each takes half a minute
ready: $(DONE)/run
	@$(MAKE) --no-print-directory $(if $(filter output-sync,$(.FEATURES)),--output-sync=line) -j$(CORES) \
		$(DONE)/compiled console

test: ready $(DONE)/dev chromium test-console  ## the whole suite, browser included (ARGS="-k docking")
	@$(BIN)/pytest $(ARGS)

CHECKS := check-types check-console check-style check-imports check-results check-figures check-containers check-gen check-docs check-declared check-leaks
test-fast: $(DONE)/compiled $(DONE)/dev test-console  ## the tests that open no browser and fly no study, side by side
	@$(BIN)/pytest -q -m "not slow" -n $(CORES) --dist loadfile $(ARGS)

test-console: $(DONE)/build  ## the console's logic, without a browser: seconds
	@$(NPM) console_web test --silent

check:  ## lint, types, import rules, generated files, containers, leaks; seconds
	@$(MAKE) --no-print-directory --output-sync=target -j$(CORES) $(CHECKS)

check-style: $(DONE)/dev
	$(BIN)/ruff check --quiet .
	$(BIN)/ruff format --quiet --check .

check-imports: $(DONE)/dev $(DONE)/project
	$(BIN)/lint-imports --no-logo

# the longest check, done anew only when a file of the product changed
TYPED = $(shell find twin server paper docs hatch_build.py -name '*.py' -o -name '*.pyi') tests/infra/types.py pyproject.toml
check-types: $(DONE)/types
$(DONE)/types: $(DONE)/dev $(DONE)/project $(TYPED)
	$(PY) -m tests.infra.types
	@touch $@

check-test-types: $(DONE)/dev $(DONE)/project  ## types of the tests
	$(PY) -m tests.infra.types tests

check-console: $(DONE)/build
	$(NPM) console_web run check --silent

check-containers: $(DONE)/dev
	$(BIN)/hadolint Dockerfile
	$(NPM) .ci exec --offline -- dclint --max-warnings 0 ../docker-compose.yml

check-results: $(DONE)/dev $(DONE)/project
	@$(PY) -m bumpless_paper.results_page --check

check-figures: $(DONE)/dev $(DONE)/project
	@$(PY) -m tests.bench.render --check

# made anew beside the tree, which the other checks are reading at the same time
check-gen: $(DONE)/dev $(DONE)/project
	@$(MAKE) --no-print-directory gen-code GEN=build/gen && for file in $(GENERATED); do \
		cmp "$$file" "build/gen/$$file" || { echo "$$file is out of date: run make gen and commit it." >&2; exit 1; }; done

check-docs: $(DONE)/dev $(DONE)/project
	$(PY) -m docs.generate --check

check-declared: $(DONE)/dev $(DONE)/project
	@$(PY) -m bumpless.config.generate --check

check-leaks:
	@! git grep -nIF -e '$(CURDIR)/' -- .
	@! git grep -nIE -e '(/home|/Users|/root)/[A-Za-z]' -- . ':!Makefile'
	@! git grep -nIE -e '--(extra-)?index-url|--find-links|--trusted-host|https?://' -- 'requirements*.lock'
	@! git grep -nI -e '"resolved":' -- '*package-lock.json'

gen: $(DONE)/dev $(DONE)/project gen-code  ## generate the contract's code, the schemas and the reference pages
	@$(PY) -m bumpless.config.generate
	@$(PY) -m docs.generate

GEN ?= .
GEN_PY = $(GEN)/twin/bumpless/contract
GEN_TS = $(GEN)/console_web/src/gen
gen-code: $(DONE)/dev $(DONE)/project
	@mkdir -p $(GEN_PY) $(GEN_TS)
	$(PY) -m grpc_tools.protoc -I twin/bumpless/contract --python_out=$(GEN_PY) --pyi_out=$(GEN_PY) bumpless.proto
	PYTHON=$(CURDIR)/$(PY) $(NPM) console_web run gen --silent -- $(CURDIR)/$(GEN_TS)
	$(PY) -m bumpless_server.web.generate $(GEN_TS) build/openapi.json
	$(NPM) .ci exec --offline -- openapi-typescript ../build/openapi.json --default-non-nullable=false --output $(CURDIR)/$(GEN_TS)/api.ts

pictures: $(DONE)/compiled $(DONE)/dev console chromium docs  ## renew the pictures of the docs from a real flight (minutes)
	@$(PY) -m tests.console.pictures

CASES ?= 10000
fuzz: $(DONE)/compiled $(DONE)/dev  ## random requests by the interface's own description, as each role (CASES=10000)
	$(PY) -m tests.fuzz --cases $(CASES) $(ARGS)

audit: $(DONE)/dev  ## known weaknesses of the dependencies, Python's and the console's; says so without a network
	@$(PY) -m tests.infra.audit

MINUTES ?= 10
results: $(DONE)/compiled  ## fly the outcomes, reproduce the paper and renew docs/results.md (ARGS="--only outcome")
	$(BIN)/bumpless reproduce --out build/reproduce $(ARGS)
	@$(PY) -m bumpless_paper.results_page build/reproduce/reproduce.json

fair: $(DONE)/compiled  ## search the gains that S2, S3 and S4 are compared with (ARGS="hard"); make results flies them
	@$(PY) -m bumpless_paper.study.fair $(ARGS)

docs: $(DONE)/build  ## build the docs, which the server shows as Help
	@$(PY) docs/build.py
	@echo "Built: server/bumpless_server/help/index.html (open it, or /help/ of a running server)"

bench: $(DONE)/compiled $(DONE)/dev $(DONE)/bench console  ## measure every speed beside its peers (ARGS="--check", "--live 1")
	$(PY) -m tests.bench $(ARGS)

bench-live: $(DONE)/compiled $(DONE)/dev console  ## a live node beside a loaded server (MINUTES=10)
	$(PY) -m tests.bench.live_node --minutes $(MINUTES) --streams 5

bench-consoles: $(DONE)/compiled $(DONE)/dev console  ## twenty consoles at 25 Hz, two stalled (MINUTES=15)
	$(PY) -m tests.bench.consoles --minutes $(MINUTES)

format: $(DONE)/dev  ## let ruff and biome format and sort imports
	$(BIN)/ruff check --select I --fix .
	$(BIN)/ruff format .
	$(NPM) console_web run format --silent

console: $(DONE)/build
	@$(PY) hatch_build.py

chromium:
	@sh tests/infra/chromium.sh

LOCK := $(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-header \
	--no-annotate --no-emit-index-url --no-emit-find-links pyproject.toml
lock: $(DONE)/build  ## resolve the dependencies anew (ARGS="--upgrade")
	$(LOCK) $(ARGS) --extra console --extra paper -o requirements.lock
	$(LOCK:pyproject.toml=) $(ARGS) --group build -c requirements.lock -o requirements-build.lock
	$(LOCK) $(ARGS) --extra all --group build --group dev -c requirements.lock -c requirements-build.lock \
		-o requirements-dev.lock
	$(LOCK) $(ARGS) --extra console --extra paper --extra bench -c requirements-dev.lock -o requirements-bench.lock

release: $(DONE)/dev $(DONE)/project  ## version, changelog, commit, wheel, tag (VERSION=x.y.z)
	@$(PY) release.py $(VERSION)

clean:  ## remove everything that was installed, built or cached (recorded data stays)
	rm -rf .venv server/bumpless_server/static server/bumpless_server/static.new server/bumpless_server/help console_web/node_modules console_web/dist .ci/node_modules
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

.PHONY: help audit fuzz pictures run ready test test-fast test-console check check-style check-imports check-types check-test-types check-console check-containers check-gen \
	check-leaks check-results check-figures check-docs check-declared gen gen-code docs release results bench bench-consoles bench-live format console chromium lock clean
