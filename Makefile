SHELL := /bin/bash
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory

PYTHON  := .venv/bin/python
PLUGINS := build/plugins
LINK    := $(PLUGINS)/skyline_viewshed
DATA    ?=
METHOD  ?= robust
COMPASS ?= ignore
PHOTOS  ?=
DEM     ?=
TORCH_PYTHON ?= build/torch/bin/python
PYTEST_ARGS ?=
export QT_QPA_PLATFORM ?= offscreen
export OMP_NUM_THREADS ?= 1
export OPENBLAS_NUM_THREADS ?= 1
# In a container of the QGIS project, PYTHONPATH says where QGIS's own modules are.
export PYTHONPATH := $(PLUGINS)$(if $(filter 1,$(SKYLINE_SYSTEM_QGIS)),$(addprefix :,$(PYTHONPATH)))

.PHONY: help
help: ## List the targets
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | awk -F ':.*## ' '{printf "  %-17s %s\n", $$1, $$2}'

.PHONY: setup
setup: link ## Install what is missing (system packages when root or with sudo, .venv)
	@tools/setup.sh

.PHONY: link
link: ## Make build/plugins/skyline_viewshed, the one name under which the package is imported
	@mkdir -p $(PLUGINS) && { [ -e $(LINK) ] || ln -s ../.. $(LINK); }

.PHONY: demo
demo: setup ## Run the main job on a simulated sample, or on PHOTOS=folder DEM=raster; result in build/demo
	@PHOTOS="$(PHOTOS)" DEM="$(DEM)" tools/demo.sh

.PHONY: sample
sample: setup ## Make build/skyline_viewshed_sample.zip (below 5 MB): photos and DEM to try the plugin with
	@$(PYTHON) tools/make_sample.py build/sample --zip build/skyline_viewshed_sample.zip

.PHONY: test
test: setup ## Run all tests
	@$(PYTHON) -m pytest $(PYTEST_ARGS)

.PHONY: test-core
test-core: setup ## Run the tests that need no QGIS
	@$(PYTHON) -m pytest tests/core tests/test_architecture.py $(PYTEST_ARGS)

.PHONY: test-qgis
test-qgis: setup ## Run the tests of the QGIS side
	@$(PYTHON) -m pytest tests/algorithms tests/panel $(PYTEST_ARGS)

.PHONY: test-bare
test-bare: setup ## Run the QGIS tests with OpenCV, pillow-heif and exifread blocked
	@SKYLINE_BARE=1 $(PYTHON) -m pytest tests/algorithms tests/core/io $(PYTEST_ARGS)

.PHONY: fuzz
fuzz: setup ## Fuzz what reads users' files: [SECONDS=600] [TARGET=metadata|pixels|heif_boxes|masks|tables|dem|...]
	@$(PYTHON) -c "import atheris" 2> /dev/null || $(PYTHON) -m pip install -q --disable-pip-version-check atheris
	@nice $(PYTHON) tests/fuzz/fuzz_readers.py --seconds $(or $(SECONDS),600) $(TARGET)

.PHONY: lint
lint: setup ## Check style, types, Qt6 readiness and the house rules
	@$(PYTHON) -m ruff check . && $(PYTHON) -m ruff format --check .
	@# QGS201 and QGS202 guess by a method's name whether it returns a success flag, and guess wrong on every addParameter.
	@$(PYTHON) -m flake8 --select QGS --extend-ignore QGS201,QGS202 plugin.py processing_provider algorithms panel
	@$(PYTHON) tools/check_types.py
	@$(PYTHON) -m pytest -q tests/test_architecture.py tests/test_house_numbers.py tests/test_qt6.py

.PHONY: format
format: setup ## Format the code
	@$(PYTHON) -m ruff check --fix . && $(PYTHON) -m ruff format .

.PHONY: bench-accuracy
bench-accuracy: setup ## Headings against the truth: DATA=folder [METHOD=robust|paper] [COMPASS=ignore|prior]
	@$(PYTHON) benchmarks/bench_accuracy.py "$(DATA)" --method $(METHOD) --compass $(COMPASS)

.PHONY: bench-skyline
bench-skyline: setup ## Skylines against masks: DATA=folder
	@$(PYTHON) benchmarks/bench_skyline.py "$(DATA)"

.PHONY: bench-sky
bench-sky: setup ## The sky network against masks that did not train it: DATA=folder [OVERLAYS=folder]
	@$(PYTHON) benchmarks/bench_sky.py "$(DATA)" $(if $(OVERLAYS),--overlays "$(OVERLAYS)")

.PHONY: train-sky
train-sky: link ## Train the sky network anew: DATA=folder [TORCH_PYTHON=python with PyTorch] [MINUTES=45]; docs/sky-model.md
	@$(TORCH_PYTHON) -c "import torch, cv2" 2> /dev/null || { echo "Training needs PyTorch and OpenCV. Make an environment for it: \
	python3 -m venv build/torch && build/torch/bin/pip install torch numpy scipy opencv-python-headless"; exit 1; }
	@$(TORCH_PYTHON) tools/sky/train.py "$(DATA)/sky" --out build/sky --minutes $(or $(MINUTES),45)
	@$(TORCH_PYTHON) tools/sky/export.py build/sky/final.pt --golden

.PHONY: bench-simulated
bench-simulated: setup ## Accuracy and calibration on seeded simulated scenes: [COUNT=240] [SEED=1] [JOBS=1]
	@$(PYTHON) benchmarks/bench_simulated.py --count $(or $(COUNT),240) --seed $(or $(SEED),1) --jobs $(or $(JOBS),1)

.PHONY: bench-views
bench-views: setup ## Headings of views cut from real photographs: DATA=folder [COUNT=6] [SEED=1] [COMPASS=ignore|prior] [JOINT=1]
	@$(PYTHON) benchmarks/bench_views.py "$(DATA)" --count $(or $(COUNT),6) --seed $(or $(SEED),1) --compass $(COMPASS) $(if $(JOINT),--joint)

.PHONY: bench-regions
bench-regions: setup ## Headings region by region, with nothing fitted on them: [DATA=../shared/data] [COMPASS=ignore|prior|random] [JOBS=1]
	@$(PYTHON) benchmarks/bench_regions.py "$(or $(DATA),../shared/data)" --compass $(COMPASS) --jobs $(or $(JOBS),1)

.PHONY: bench-joint
bench-joint: setup ## Photographs of a walk together and alone: [DATA=../shared/data] [COMPASS=ignore|prior] [JOBS=1]
	@$(PYTHON) benchmarks/bench_joint.py "$(or $(DATA),../shared/data)" --compass $(COMPASS) --jobs $(or $(JOBS),1)

.PHONY: bench-locate
bench-locate: setup ## Places of photographs whose position is withheld: [DATA=../shared/data]
	@$(PYTHON) benchmarks/bench_locate.py "$(or $(DATA),../shared/data)"

.PHONY: bench-index
bench-index: setup ## Time, memory and size of an index of horizons: DEM=file [KM2="400 1600"]
	@$(PYTHON) benchmarks/bench_index.py "$(DEM)" --km2 $(or $(KM2),400 1600)

.PHONY: bench-monoplot
bench-monoplot: setup ## Ground error and error ellipses of monoplotting, on simulated scenes: [SCENES=60]
	@$(PYTHON) benchmarks/bench_monoplot.py --scenes $(or $(SCENES),60)

.PHONY: bench-panel
bench-panel: setup ## Speed and memory of the Photo view: [COUNT=300]
	@$(PYTHON) benchmarks/bench_panel.py --photos $(or $(COUNT),300)

.PHONY: bench-review
bench-review: setup ## Time that the Photo view takes of a reviewer's hour: [COUNT=500] [LOOK=seconds] [DATA=../shared/data]
	@$(PYTHON) benchmarks/bench_review.py --photos $(or $(COUNT),500) --look $(or $(LOOK),0) --data "$(or $(DATA),../shared/data)"

.PHONY: bench-speed
bench-speed: setup ## Horizon and viewshed against their peers
	@$(PYTHON) benchmarks/bench_speed.py

.PHONY: env
env: setup ## Print the variables with which a plain qgis_process sees the plugin: eval "$$(make env)"
	@tools/env.sh

.PHONY: models
models: setup ## Rebuild models/*.model3 from tools/make_models.py
	@$(PYTHON) tools/make_models.py

.PHONY: docs
docs: setup ## Renew what docs/ takes from the code: algorithm reference, tables of fields
	@$(PYTHON) tools/make_docs.py

.PHONY: accuracy-page
accuracy-page: setup ## Measure on the folders in DATA and write the tables of docs/accuracy.md: [DATA=folder]
	@$(PYTHON) tools/measure.py $(DATA)

.PHONY: screenshots
screenshots: setup ## Renew docs/images from the demo, in a QGIS of its own under Xvfb
	@tools/screenshots/run.sh

.PHONY: zip
zip: setup ## Make build/skyline_viewshed.zip from the last commit, ready for the plugin site
	@rm -f build/skyline_viewshed.zip && $(PYTHON) tools/make_translations.py --compile-only > build/translations.log
	@git archive --format=zip --prefix=skyline_viewshed/i18n/ $(foreach file,$(basename $(wildcard i18n/*.ts)),--add-file=$(file).qm) \
		--prefix=skyline_viewshed/ -o build/skyline_viewshed.zip HEAD && echo build/skyline_viewshed.zip

.PHONY: wheel
wheel: setup ## Make build/wheel/*.whl: the core, its Python functions and its command line, for use without QGIS
	@rm -rf build/wheel && $(PYTHON) -m pip wheel -q --disable-pip-version-check --no-deps -w build/wheel . && ls build/wheel/*.whl

.PHONY: check-package
check-package: zip ## Hold the zip to the plugin site's rules and run it from an empty profile
	@$(PYTHON) tools/check_package.py build/skyline_viewshed.zip

.PHONY: publish
publish: check-package ## Upload the checked zip to the plugin site: QGIS_PLUGIN_TOKEN=token of this plugin
	@tools/publish.sh build/skyline_viewshed.zip

.PHONY: test-matrix
test-matrix: ## Run all tests on QGIS 3.22, 3.40 and 3.44, each in a Debian tree of its own (as root)
	@tools/test_matrix.sh $(SUITES)

.PHONY: fresh-machine
fresh-machine: ## Prove make demo and make test on a new minimal Debian (as root)
	@tools/fresh_machine.sh

.PHONY: translations
translations: setup ## Renew i18n/*.ts from the source and compile them to *.qm
	@$(PYTHON) tools/make_translations.py

.PHONY: install
install: zip ## Install into the QGIS profile of this user
	@tools/install.sh

.PHONY: clean
clean: ## Remove what was built; .venv stays
	@find . -name __pycache__ -not -path './.venv/*' -prune -exec rm -rf {} + ; rm -rf build/* .pytest_cache .ruff_cache .hypothesis
