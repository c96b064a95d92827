# `make demo` sets everything up and draws a face; `make test` runs the tests.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
OUT := out

.PHONY: demo test check bench clean

demo: $(VENV)/.ready
	@mkdir -p $(OUT)
	$(BIN)/skinshade render --compare lambert,classic,transfer,transfer+deep --size 480x720 \
		--light=-38,26,0.75 --light=152,12,1.6 -o $(OUT)/demo.png
	@echo "Open $(OUT)/demo.png: lambert | classic | transfer | transfer + deep scatter"

test: $(VENV)/.ready
	$(BIN)/python -m pytest -n auto

check: $(VENV)/.ready
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports

bench: $(VENV)/.ready
	$(BIN)/python benchmarks/performance.py

# One environment for all targets; made again when the dependencies change.
$(VENV)/.ready: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "skinshade needs Python 3.11 or newer; $(PYTHON) is older"; exit 2; }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[dev]'
	@touch $@

clean:
	rm -rf $(VENV) $(OUT)
