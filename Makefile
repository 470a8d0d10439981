# The front door: everything here is a short name for a cmake preset or a script.
# `make run` and `make test` work on a bare Debian 12 with git, make and root or sudo.

JOBS         ?= $(shell scripts/jobs.sh)
PREFIX       ?= /usr/local
FUZZ_SECONDS ?= 900
MAKEFLAGS    += --no-print-directory

programs = gcode2lua gsim-run gsim-data path2gcode autopath

# Configuring is quiet (warnings and errors go to standard error), building shows its progress.
build_into = cmake --preset $(1) >/dev/null && cmake --build --preset $(1) --parallel $(JOBS)

.PHONY: help run test setup build bench accuracy docs fuzz golden format lint install clean

help:
	@echo 'make run      translate samples/wheel.nc, show the Lua, simulate it'
	@echo 'make test     build everything and run all tests'
	@echo 'make setup    install the Debian packages that are missing'
	@echo 'make build    build the programs into build/bin'
	@echo 'make bench    measure, against LinuxCNC where it is installed; writes build/bench.md'
	@echo 'make accuracy GSIM_REFERENCE=FOLDER  compare cycle times and positions with recorded controllers'
	@echo 'make fuzz     fuzz the translator for FUZZ_SECONDS=$(FUZZ_SECONDS)'
	@echo 'make golden   renew the expected outputs of the golden tests; read the diff afterwards'
	@echo 'make docs     renew docs/language.md from the tables'
	@echo 'make format   format the C++ sources'
	@echo 'make lint     check the format, then run clang-tidy'
	@echo 'make install  install into PREFIX=$(PREFIX) (DESTDIR is honoured)'
	@echo 'make clean    remove the build folders'

setup:
	@scripts/setup.sh

run: build
	@scripts/run-wheel.sh build

build: setup
	@$(call build_into,release) --target $(programs)

test: setup
	@$(call build_into,release)
	@scripts/test.sh build --parallel $(JOBS)

golden: setup
	@$(call build_into,release) --target golden_test
	@GSIM_RENEW_GOLDEN=1 ctest --test-dir build --output-on-failure -R '^golden_test$$'

bench: setup
	@$(call build_into,release) --target gcode2lua gsim-run gsim-bench-generate gsim-bench-floor gsim-bench-compare
	@bench/run.sh build

# The recordings are no part of the project. An empty name must not become the folder '/'.
ifeq ($(and $(GSIM_REFERENCE),$(wildcard $(GSIM_REFERENCE)/.)),)
accuracy:
	@echo "accuracy: there is no folder '$(GSIM_REFERENCE)' of recorded controllers; name it: make accuracy GSIM_REFERENCE=FOLDER"
else
accuracy: setup
	@$(call build_into,release) --target gsim-run gsim-accuracy
	@build/bin/gsim-accuracy --gsim-run build/bin/gsim-run --machines samples/machines --positions '$(GSIM_REFERENCE)'
endif

docs: setup
	@$(call build_into,release) --target gcode2lua
	@build/bin/gcode2lua --print-language > docs/language.md

fuzz:
	@scripts/setup.sh clang
	@$(call build_into,fuzz) --target translate_fuzz
	@tests/fuzz/run.sh build-fuzz $(FUZZ_SECONDS)

format:
	@scripts/setup.sh lint
	@scripts/sources.sh | xargs -r clang-format -i

lint:
	@scripts/setup.sh lint
	@scripts/lint.sh format
	@$(call build_into,release) --target $(programs)
	@scripts/lint.sh tidy build

install: build
	@cmake --install build --prefix '$(PREFIX)'

clean:
	@rm -rf build build-debug build-sanitize build-fuzz
