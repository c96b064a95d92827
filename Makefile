# `make demo` sets everything up and draws a face; `make test` runs the tests.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
OUT := out

.PHONY: demo test check bench shaders clean

demo: $(VENV)/.ready
	@mkdir -p $(OUT)
	$(BIN)/skinshade render --compare lambert,classic,transfer,transfer+deep --size 480x720 \
		--light=-38,26,0.75 --light=152,12,1.6 -o $(OUT)/demo.png
	@echo "Open $(OUT)/demo.png: lambert | classic | transfer | transfer + deep scatter"

test: $(VENV)/.tools
	$(BIN)/python -m pytest -n auto

check: $(VENV)/.tools
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: $(VENV)/.tools
	$(BIN)/python benchmarks/performance.py
	$(BIN)/python benchmarks/bake_scale.py
	$(BIN)/python benchmarks/gpu_cost.py
	$(BIN)/python benchmarks/gpu_instructions.py

# What the compiler makes of shaders/skin; a test proves that it is committed.
shaders: $(VENV)/.tools
	$(BIN)/python -m skinshade.codegen

# The Slang compiler comes in the wheel of its PyTorch binding, which would pull PyTorch.
$(VENV)/.tools: $(VENV)/.ready $(wildcard tools/*.py)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps slangtorch==1.3.22
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
	rm -rf $(VENV) $(OUT)
