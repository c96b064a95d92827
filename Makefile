# `make demo` sets everything up and draws a face; `make test` runs the tests.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/$(if $(filter Windows_NT,$(OS)),Scripts,bin)
OUT := out
SECONDS ?= 600
SEED ?= 0

.PHONY: demo test test-lowest check bench fuzz shaders native sanitize wheel wheels clean

demo: $(VENV)/.ready
	@mkdir -p $(OUT)
	$(BIN)/skinshade render --compare lambert,classic,transfer,transfer+deep --size 480x720 \
		--light=-38,26,0.75 --light=152,12,1.6 -o $(OUT)/demo.png
	@echo "Open $(OUT)/demo.png: lambert | classic | transfer | transfer + deep scatter"

test: $(VENV)/.tools
	$(BIN)/python -m pytest -n auto

# The tests with the lowest versions of all dependencies that pyproject.toml allows.
test-lowest: $(VENV)/.tools
	$(BIN)/python tools/lowest_versions.py $(VENV)-lowest

check: $(VENV)/.tools
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: $(VENV)/.tools
	$(BIN)/python benchmarks/performance.py
	$(BIN)/python benchmarks/mesh_analysis.py
	$(BIN)/python benchmarks/bake_scale.py
	$(BIN)/python benchmarks/gpu_cost.py
	$(BIN)/python benchmarks/gpu_instructions.py

# Changed files for every reader: `make fuzz SECONDS=60 SEED=3`. Findings are written to fuzz/findings.
fuzz: $(VENV)/.ready
	$(BIN)/python -m fuzz --seconds $(SECONDS) --seed $(SEED)

# Generated files of src/skinshade/shading/generated and docs; a test proves that they are current.
shaders: $(VENV)/.tools
	$(BIN)/python -m codegen

# The compiled kernels, next to their sources.
native: $(VENV)/.ready
	$(BIN)/python tools/native_library.py

# The tests of the compiled kernels with checks of addresses and undefined behaviour.
sanitize: $(VENV)/.ready
	$(BIN)/python tools/sanitize.py

# Wheels with compiled kernels for all systems; runs that of this system.
wheels: $(VENV)/.ready
	$(BIN)/python tools/wheels.py

wheel: $(VENV)/.ready
	$(BIN)/python -m pip wheel --quiet --disable-pip-version-check --no-deps --wheel-dir dist .

# Programs and drivers that only the tests and `make shaders` need.
$(VENV)/.tools: $(VENV)/.ready $(wildcard tools/*.py)
	$(BIN)/python tools/shader_compiler.py
	$(BIN)/python tools/software_driver.py
	$(BIN)/python tools/language_tools.py
	$(BIN)/python tools/gltf_validator_tool.py
	@touch $@

# One environment for all targets; made again when the dependencies change.
$(VENV)/.ready: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "skinshade needs Python 3.11 or newer; $(PYTHON) is older"; exit 2; }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	@touch $@

clean:
	rm -rf $(VENV) $(VENV)-lowest $(OUT) dist
