# make eval   install and write a report on a scene (SCENE=folder, default the bundled one)
# make test   install and run the tests
# make help   the other targets

PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
SCENE ?= data_gen/bundled/figure
ARGS ?=

.PHONY: eval schedules bench test lint data help clean

eval: $(VENV)/eval.installed ## λ report of a scene
	$(BIN)/python -m eval lambda --scene "$(SCENE)" $(ARGS)

schedules: $(VENV)/eval.installed ## propose_commit against scanline at every λ (slow)
	$(BIN)/python -m eval schedules --scene "$(SCENE)" $(ARGS)

bench: $(VENV)/eval.installed ## time and energy, beside ebsynth with EBSYNTH=path
	$(BIN)/python -m eval bench --scene "$(SCENE)" $(if $(EBSYNTH),--ebsynth "$(EBSYNTH)") $(ARGS)

data: $(VENV)/eval.installed ## render the bundled scene anew
	$(BIN)/python -m data_gen

test: $(VENV)/test.installed ## all tests
	$(BIN)/python -m pytest $(ARGS)

lint: $(VENV)/lint.installed ## ruff and import contracts
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports

$(VENV)/%.installed: pyproject.toml
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable ".[$*]"
	touch $@

help:
	@grep -E '^[a-z]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## */\t/'

clean: ## remove the environment and cached runs
	rm -rf $(VENV) build
