# The targets of this project; `make help` lists them. Each sets up what it needs in .venv.

PYTHON ?= python3
VENV   := .venv
BIN    := $(VENV)/bin
# How long `make fuzz` runs each of its targets.
FUZZ_SECONDS ?= 300
FUZZ   := .tools/bin/cargo-fuzz
PIP    := $(BIN)/python -m pip install --quiet --constraint requirements.txt
# The build finds the environment to install into by this variable.
export VIRTUAL_ENV := $(CURDIR)/$(VENV)

.DEFAULT_GOAL := help
.PHONY: help reproduce studies benchmark test lint types test-rust test-python test-wheel bench fuzz lock clean develop

help: ## list the targets
	@grep -hE '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/^([a-z-]+):.*## /\1\t/' | expand -t 14

reproduce: $(VENV)/.run develop ## the paper's four figures and the comparison, into figures/
	$(BIN)/divbandit reproduce --out figures

studies: $(VENV)/.test develop ## the studies of docs/studies.md and docs/environments.md, into studies/
	for study in rules strategies composition environments; do $(BIN)/divbandit study $$study --out studies || exit 1; done

benchmark: $(VENV)/.test develop ## default_strategy beside pyribs, into benchmark/ (half an hour)
	$(BIN)/divbandit benchmark --out benchmark

test: $(VENV)/.test lint develop types test-rust test-python test-wheel ## every check that CI runs

bench: $(VENV)/.test develop ## kernels (criterion), peers, whole explorations, runs; the peers' table goes into the README
	cargo bench --locked --package divbandit-core
	$(BIN)/python benches/peers.py --readme README.md
	$(BIN)/maturin develop --release --locked --manifest-path benches/scalar_arm/Cargo.toml
	$(BIN)/python benches/engine.py
	$(BIN)/python benches/ask_tell.py
	$(BIN)/python benches/running.py

fuzz: $(FUZZ) ## the coverage kernels' laws on hostile effects, FUZZ_SECONDS (300) for each target
	@for target in plane space; do \
		mkdir -p fuzz/corpus/$$target && \
		echo "fuzzing $$target for $(FUZZ_SECONDS) s from fuzz/seeds/$$target" && \
		$(FUZZ) run --sanitizer none $$target fuzz/corpus/$$target fuzz/seeds/$$target \
			-- -max_total_time=$(FUZZ_SECONDS) -max_len=512 -timeout=20 -print_final_stats=1 || exit 1; \
	done

lint: $(VENV)/.test # formatting and linters of both languages
	cargo fmt --all --check
	cargo clippy --locked --workspace --all-targets -- -D warnings
	cargo fmt --manifest-path fuzz/Cargo.toml --check
	cargo fmt --manifest-path benches/scalar_arm/Cargo.toml --check
	$(BIN)/ruff format --check
	$(BIN)/ruff check

types: $(VENV)/.test develop # strict types, and stubs that say what the compiled module does
	$(BIN)/mypy
	$(BIN)/python -m mypy.stubtest divbandit._core

test-rust:
	cargo test --locked --package divbandit-core
	RUSTDOCFLAGS="-D warnings" cargo doc --locked --no-deps --package divbandit-core

test-python: $(VENV)/.test develop
	MPLBACKEND=Agg $(BIN)/python -m pytest --numprocesses auto --dist worksteal

test-wheel: $(VENV)/.test # the wheel alone, with NumPy and nothing else, in an empty environment
	rm -rf dist .wheel-venv
	$(BIN)/maturin build --quiet --release --locked --out dist
	$(PYTHON) -m venv .wheel-venv
	.wheel-venv/bin/python -m pip install --quiet --constraint requirements.txt dist/*.whl
	cd dist && ../.wheel-venv/bin/python -I ../tests/smoke.py

lock: $(VENV)/.test # renew requirements.txt from pyproject.toml
	$(PIP) pip-tools
	$(BIN)/pip-compile --quiet --upgrade --strip-extras --extra test --no-emit-index-url \
		--no-emit-find-links --no-emit-trusted-host --unsafe-package divbandit --output-file requirements.txt pyproject.toml

clean: ## remove everything that was built
	rm -rf target fuzz/target benches/scalar_arm/target .tools dist figures studies $(VENV) .wheel-venv .mypy_cache .pytest_cache .ruff_cache .hypothesis

# The compiled module, built in place; quick when nothing has changed.
develop: $(VENV)/.run
	$(BIN)/maturin develop --release --locked > $(VENV)/develop.log 2>&1 || { cat $(VENV)/develop.log; exit 1; }

$(FUZZ):
	cargo install --quiet --locked --root .tools --version 0.13.2 cargo-fuzz

$(VENV)/.run: requirements.txt
	$(PYTHON) -m venv $(VENV)
	$(PIP) cloudpickle loky maturin matplotlib numpy tqdm
	touch $@

$(VENV)/.test: $(VENV)/.run requirements.txt
	$(PIP) --requirement requirements.txt
	touch $@
