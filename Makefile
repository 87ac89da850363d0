# make eval   install and regenerate the thesis' tables and figures: PRESET=quick or thesis
# make test   install and run the tests; make test-fast the quick ones
# make help   the other targets

PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
SCENE ?= golem/crayon
DATA ?= data_gen/bundled
SIZE ?= 1200x912
PRESET ?= quick
ARGS ?=
WORKERS ?= 2
PYTHONS ?= 3.11 3.12 3.13 3.14

.PHONY: eval schedules epsilon stylit spilling bench scenes test test-fast test-gpu ptx docs wheel lowest lint data help clean

eval: $(VENV)/$(if $(SCHEDULER),cluster,eval).installed ## tables and figures of the thesis: PRESET, SCHEDULER, ARGS="--scene DIR"
	$(BIN)/python -m eval thesis --preset "$(PRESET)" $(if $(SCHEDULER),--scheduler "$(SCHEDULER)") $(ARGS)

schedules: $(VENV)/eval.installed ## propose_commit against scanline at every λ (slow)
	$(BIN)/python -m eval schedules --scene "$(SCENE)" --data "$(DATA)" $(ARGS)

epsilon: SCENE = golem/oil
epsilon: $(VENV)/eval.installed ## guide maps at every ε, and what they save
	$(BIN)/python -m eval epsilon --scene "$(SCENE)" --data "$(DATA)" $(ARGS)

stylit: $(VENV)/eval.installed ## StyLit beside the occurrence map
	$(BIN)/python -m eval stylit --scene "$(SCENE)" --data "$(DATA)" $(ARGS)

spilling: SCENE = scorpion/watercolour,hand/watercolour,golem/oil,stego/crayon,teapot/oil
spilling: $(VENV)/eval.installed ## what an ID guide cures: SCENE=TARGET/STYLE,...
	$(BIN)/python -m eval spilling --scene "$(SCENE)" --data "$(DATA)" $(ARGS)

bench: $(VENV)/eval.installed ## time and energy, beside ebsynth with EBSYNTH=path
	$(BIN)/python -m eval bench --scene "$(SCENE)" --data "$(DATA)" $(if $(EBSYNTH),--ebsynth "$(EBSYNTH)") $(ARGS)

scenes: $(VENV)/eval.installed ## contact sheets, and every target in every style
	$(BIN)/python -m eval scenes --data "$(DATA)" $(ARGS)

data: $(VENV)/render.installed ## render scenes and styles: SIZE=1200x912, SCENES=teapot,house
	$(BIN)/python -m data_gen --size "$(SIZE)" $(if $(SCENES),--scenes "$(SCENES)") $(ARGS)

test: $(VENV)/test.installed ## all tests; those of the CUDA kernels in Numba's simulator
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(ARGS)
	NUMBA_ENABLE_CUDASIM=1 $(BIN)/python -m pytest -n $(WORKERS) tests/gpu_cuda

test-fast: $(VENV)/test.installed ## the tests that take less than a minute together, kernels compiled
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -m "not slow" $(ARGS)

test-gpu: $(VENV)/gpu.installed $(VENV)/test.installed ## tests of the CUDA kernels on a GPU, and its times
	$(BIN)/python -m pytest tests/gpu_cuda
	$(BIN)/python -m eval.gpu_record $(ARGS)

ptx: .venv-ptx/ptx.installed ## every CUDA kernel compiled, no GPU needed
	.venv-ptx/bin/python -m eval.ptx_report

DIST := build/dist
UV := $(BIN)/uv --quiet --no-python-downloads
TRY = rm -rf build/try && mkdir -p build/try && cd build/try && PATH="$(abspath $(1))/bin:$$PATH" && \
	command=$$(stylit-ref example scenes) && eval "$$command --preset fast --quiet"

wheel: $(VENV)/wheel.installed ## wheel and source made; the wheel in an empty environment of every Python there is
	rm -rf $(DIST)
	$(BIN)/python -m build --outdir $(DIST)
	$(MAKE) $(PYTHONS:%=wheel-%)

wheel-%: # what it needs must be there as wheels, whether this Python is at hand or not
	$(UV) pip compile --python-version $* --only-binary :all: --extra render pyproject.toml >build/python$*.txt
	if $(UV) python find $* >/dev/null 2>&1; then \
		$(UV) venv --clear --python $* build/python$* && $(UV) pip install --python build/python$* $(DIST)/*.whl && $(call TRY,build/python$*); \
	else echo "Python $*: not at hand, its wheels are"; fi

lowest: wheel ## the source with the least versions that pyproject.toml admits, and the oracle
	$(UV) venv --clear --python 3.11 build/lowest
	$(UV) pip compile --python build/lowest --resolution lowest-direct pyproject.toml -o build/lowest.txt
	$(UV) pip install --python build/lowest --constraint build/lowest.txt $(DIST)/*.tar.gz
	$(call TRY,build/lowest)
	build/lowest/bin/stylit-ref oracle check

lint: $(VENV)/lint.installed ## ruff and import contracts
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports

docs: $(VENV)/docs.installed ## the site, build/site/index.html: docs, notebooks, API, reports
	$(BIN)/sphinx-build -W --keep-going --quiet -c docs . build/site

%.installed: pyproject.toml
	test -x $(@D)/bin/python || $(PYTHON) -m venv $(@D)
	$(@D)/bin/python -m pip install --quiet --disable-pip-version-check --editable ".[$(*F)]"
	touch $@

help:
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## */\t/'

clean: ## remove the environments and all of build/: cached runs, rendered scenes
	rm -rf $(VENV) .venv-ptx build
