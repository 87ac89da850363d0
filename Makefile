# make eval   install, and regenerate the tables, figures and claims of four publications
# make test   install and run the tests; make test-fast the quick ones
# make help   the other targets

PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
SCENE ?=
DATA ?=
SIZE ?= 1200x912
PRESET ?=
ARGS ?=
WORKERS ?= 2
PYTHONS ?= 3.11 3.12 3.13 3.14

.PHONY: eval reports schedules epsilon stylit spilling levels bench waits scenes test test-fast test-gpu ptx docs notebooks wheel lowest lint viewer bundles data turntable blender help clean

OF_ONE := $(PRESET)$(SCHEDULER)$(ARGS)
eval: $(VENV)/$(if $(SCHEDULER),cluster,eval).installed ## make the reports on four publications; DOCUMENT=dzurenko, lasram, heidrich or hauptfleisch: one, with PRESET, ARGS, and for dzurenko SCHEDULER=ADDRESS
	$(if $(DOCUMENT),,$(if $(OF_ONE),$(error PRESET, ARGS and SCHEDULER are for one report: add DOCUMENT=dzurenko, lasram, heidrich or hauptfleisch)))
	$(BIN)/python -m eval $(or $(DOCUMENT),documents) $(if $(PRESET),--preset "$(PRESET)") $(if $(SCHEDULER),--scheduler "$(SCHEDULER)") $(ARGS)

reports: $(VENV)/eval.installed ## copy finished reports to reports/, made small: ARGS=NAME for a new one
	$(BIN)/python -m eval publish $(ARGS)

report-%: $(VENV)/eval.installed # any report of python -m eval --help
	$(BIN)/python -m eval $* $(if $(SCENE),--scene "$(SCENE)") $(if $(DATA),--data "$(DATA)") $(if $(EBSYNTH),--ebsynth "$(EBSYNTH)") $(ARGS)

schedules: report-schedules ## compare the schedules propose_commit and scanline at every λ (slow)

epsilon: report-epsilon ## measure what guide maps change and save, at every ε

stylit: report-stylit ## compare StyLit with the occurrence map

spilling: report-spilling ## measure spilling without and with an ID guide: SCENE=TARGET/STYLE,...

levels: report-levels ## measure how many pyramid levels serve at each size, after make data: DATA=DIR,...

bench: report-bench ## measure time, memory and energy: EBSYNTH=PATH measures ebsynth too

waits: report-waits ## measure where people wait: ARGS="--before FOLDER" measures another version beside this one

scenes: report-scenes ## show all scenes, and every target in every style

data: $(VENV)/render.installed ## render scenes and styles: SIZE=1200x912, SCENES=teapot,house
	$(BIN)/python -m data_gen --size "$(SIZE)" $(if $(SCENES),--scenes "$(SCENES)") $(ARGS)

turntable: $(VENV)/render.installed ## render the scene that the studio opens with; 5 minutes
	$(BIN)/python -m data_gen --size 500x500 --scenes turntable --guides-only --folder build/turntable
	$(BIN)/python -m data_gen.turntable build/turntable

blender: .venv-blender/bpy.installed $(VENV)/eval.installed ## render a shot in Blender, check its vectors, and stylize it; needs Python 3.11 and 1.2 GB
	.venv-blender/bin/python data_gen/blender_shot.py build/blender
	$(BIN)/python -m eval blender $(ARGS)

test: $(VENV)/test.installed ## run all tests; those of the CUDA kernels run in Numba's simulator
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal $(ARGS)
	NUMBA_ENABLE_CUDASIM=1 $(BIN)/python -m pytest -n $(WORKERS) tests/gpu_cuda

test-fast: $(VENV)/test.installed ## run the quick tests: less than a minute, once the kernels are compiled
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -m "not slow" $(ARGS)

test-gpu: $(VENV)/gpu.installed $(VENV)/test.installed ## run the tests of the CUDA kernels on a GPU, and time the kernels
	$(BIN)/python -m pytest tests/gpu_cuda
	$(BIN)/python -m eval gpu $(ARGS)

ptx: .venv-ptx/ptx.installed ## compile every CUDA kernel; no GPU is needed
	.venv-ptx/bin/python -m eval ptx

DIST := build/dist
UV := $(BIN)/uv --quiet --no-python-downloads
TRY = rm -rf build/try && mkdir -p build/try && cd build/try && PATH="$(abspath $(1))/bin:$$PATH" && \
	command=$$(stylit-ref example scenes) && eval "$$command --preset fast --quiet"

wheel: $(VENV)/wheel.installed ## build the wheel and the source package; try the wheel with every installed Python
	rm -rf $(DIST)
	$(BIN)/python -m build --outdir $(DIST)
	$(MAKE) $(PYTHONS:%=wheel-%)

wheel-%: # its dependencies must exist as wheels, even if this Python is not installed here
	$(UV) pip compile --python-version $* --only-binary :all: --extra render pyproject.toml >build/python$*.txt
	if $(UV) python find $* >/dev/null 2>&1; then \
		$(UV) venv --clear --python $* build/python$* && $(UV) pip install --python build/python$* $(DIST)/*.whl && $(call TRY,build/python$*); \
	else echo "Python $*: not installed here, but its wheels exist"; fi

lowest: wheel ## try the source package with the oldest versions that pyproject.toml allows
	$(UV) venv --clear --python 3.11 build/lowest
	$(UV) pip compile --python build/lowest --resolution lowest-direct pyproject.toml -o build/lowest.txt
	$(UV) pip install --python build/lowest --constraint build/lowest.txt $(DIST)/*.tar.gz
	$(call TRY,build/lowest)
	build/lowest/bin/stylit-ref oracle check

lint: $(VENV)/lint.installed ## ruff, import contracts, and whether every public name has a type
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	PATH="$(abspath $(BIN)):$$PATH" pyright --verifytypes stylit_ref --ignoreexternal
	$(MAKE) bundles-check

HOUSE := build/data/600x456
viewer: $(VENV)/render.installed ## make the example page of the viewer, the house: build/viewer/house.html
	$(BIN)/python -m data_gen --size 600x456 --scenes house_5
	$(BIN)/stylit-ref views --preset fast --manifest $(HOUSE)/manifests/house/views.json --run build/viewer/run --output 'build/viewer/{view}.png'
	$(BIN)/stylit-ref viewer build/viewer/run --title "A sketched house" --output build/viewer/house.html

PAGES := viewer studio
BUNDLE = cd stylit_ref/$(1) && ../../node_modules/.bin/esbuild src/main.ts --bundle --format=iife --target=es2022 \
	--legal-comments=none --log-level=warning --outfile=$(2)

bundles: node_modules/.package-lock.json ## build the programs of the pages from their TypeScript; needs Node.js
	node_modules/.bin/tsc --noEmit
	$(foreach page,$(PAGES),($(call BUNDLE,$(page),bundle/$(page).js)) &&) true

bundles-check: # the committed programs are those of their sources
	@if command -v npm >/dev/null; then $(MAKE) $(PAGES:%=bundle-compare-%); else echo "no npm here: the pages' programs are not compared with their sources"; fi

bundle-compare-%: node_modules/.package-lock.json
	mkdir -p build
	node_modules/.bin/tsc --noEmit
	$(call BUNDLE,$*,../../build/$*.js)
	cmp build/$*.js stylit_ref/$*/bundle/$*.js || { echo "run make bundles, and commit what it builds"; exit 1; }

node_modules/.package-lock.json: package-lock.json
	npm ci --no-audit --no-fund --silent
	touch $@

docs: $(VENV)/docs.installed node_modules/.package-lock.json ## build the site, build/site/index.html: docs, notebooks, API, reports; needs Node.js
	$(BIN)/sphinx-build -W --keep-going --quiet -c docs . build/site

notebooks: $(VENV)/notebooks.installed ## make the notebooks for Jupyter, build/jupyter/*.ipynb
	$(BIN)/python docs/jupyter_notebooks.py build/jupyter
	@echo "To open them: $(BIN)/jupyter lab build/jupyter"

.venv-blender/bpy.installed: # in an environment of its own: it needs NumPy 1
	test -x $(@D)/bin/python || $(PYTHON) -m venv $(@D)
	$(@D)/bin/python -m pip install --quiet --disable-pip-version-check bpy==5.0.1
	touch $@

%.installed: pyproject.toml
	test -x $(@D)/bin/python || $(PYTHON) -m venv $(@D)
	$(@D)/bin/python -m pip install --quiet --disable-pip-version-check --editable ".[$(*F)]"
	touch $@

help:
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## */\t/'

clean: ## remove the environments and all of build/, with cached runs and rendered scenes
	rm -rf $(VENV) .venv-ptx .venv-blender build
