# One command for each habit. Windows has no make: type the lines there, with .venv\Scripts\python.
python = .venv/bin/python

.PHONY: setup test lint pictures bench

setup: .venv

.venv: pyproject.toml
	python3 -m venv .venv
	$(python) -m pip install -e ".[test]"
	touch .venv

test: .venv
	$(python) -m pytest

lint: .venv
	PATH="$(CURDIR)/.venv/bin:$$PATH" .ci/lint

pictures: .venv  # and the A-Z page, and the sheet of all calls
	$(python) -m tools.pictures
	$(python) -m tools.a_to_z
	$(python) -m tools.sheet

bench: .venv
	$(python) -m bench
