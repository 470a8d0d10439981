# Entry point: every target is a short name for a cmake preset or a script.
# `make run` and `make test` work on a bare Debian 12 with git, make and root or sudo.

JOBS         ?= $(shell scripts/jobs.sh)
PREFIX       ?= /usr/local
FUZZ_SECONDS ?= 10
MAKEFLAGS    += --no-print-directory

# Configuring is quiet (warnings and errors go to standard error), building shows its progress.
build_into = cmake --preset $(1) >/dev/null && cmake --build --preset $(1) --parallel $(JOBS)

.PHONY: help run test check test-all setup build bench accuracy calibration coverage docs pictures site fuzz golden format lint wasm studio studio-test install uninstall package clean

help:
	@echo 'make run      build gcode2lua and gsim-run alone, translate samples/wheel.nc, show the Lua, simulate it'
	@echo 'make test     build everything and run all tests'
	@echo 'make check    the checks that uncommitted and unpushed changes touch, cheapest first, up to the first failure'
	@echo 'make test-all the same as make test, and faults at every place instead of a sample of them'
	@echo 'make setup    install the Debian packages that building the programs takes'
	@echo 'make build    build the programs into build/bin'
	@echo 'make bench    measure, against LinuxCNC where it is installed; writes build/bench.md'
	@echo 'make accuracy GSIM_REFERENCE=FOLDER  compare cycle times and positions with recorded controllers'
	@echo 'make calibration GSIM_REFERENCE=FOLDER  fit generic models to recorded controllers, and tell how near they foretell the others'
	@echo 'make fuzz     fuzz each reader for FUZZ_SECONDS=$(FUZZ_SECONDS), or the one TARGET=NAME; RECORD=1 counts it in tests/fuzz/RESULTS.md'
	@echo 'make coverage what of the sources the tests run, by module; the report in build-coverage/report'
	@echo 'make golden   renew the expected outputs of the golden tests; read the diff afterwards'
	@echo 'make docs     renew docs/language.md and docs/services.md from the tables'
	@echo 'make pictures renew the pictures of the documentation'
	@echo 'make site     the documentation as pages with a search, in build/site'
	@echo 'make format   format the C++ sources'
	@echo 'make lint     check the format, then run clang-tidy'
	@echo 'make wasm     the program as WebAssembly for node, and its answers compared with the native ones, byte for byte'
	@echo 'make studio   the page that shows a run in a browser, into build/share/gsim/studio (installs emscripten: 800 MB)'
	@echo 'make studio-test  try that page in Chromium, without a window'
	@echo 'make install  install into PREFIX=$(PREFIX) (DESTDIR is honoured)'
	@echo 'make uninstall  remove what make install installed (DESTDIR as it was)'
	@echo 'make package  Debian packages and an archive for other systems, in build/packages'
	@echo 'make clean    remove the build folders'

setup:
	@scripts/setup.sh

run: setup
	@$(call build_into,release) --target gsim-first
	@scripts/run-wheel.sh build

build: setup
	@$(call build_into,release) --target product

test:
	@scripts/setup.sh test
	@$(call build_into,release)
	@scripts/test.sh build --parallel $(JOBS)

check:
	@scripts/check.sh touched

wasm: build
	@scripts/setup.sh wasm
	@scripts/wasm-sources.sh
	@$(call build_into,wasm) --target gsim
	@scripts/wasm-compare.py

studio: build
	@scripts/setup.sh wasm studio
	@scripts/wasm-sources.sh
	@$(call build_into,wasm) --target gsim-studio-engine
	@scripts/studio.sh build

studio-test: studio
	@scripts/setup.sh browser
	@scripts/studio-test.sh build --required

test-all:
	@scripts/setup.sh test
	@$(call build_into,release)
	@GSIM_TEST_ALL=1 scripts/test.sh build --parallel $(JOBS)

golden:
	@scripts/setup.sh test
	@$(call build_into,release) --target golden_test golden_run_test
	@GSIM_RENEW_GOLDEN=1 ctest --test-dir build --output-on-failure -R '^golden'

bench: setup
	@$(call build_into,release) --target gsim gsim-bench-generate gsim-bench-floor gsim-bench-compare
	@bench/run.sh build

# The recordings are not part of the project. An empty name must not become the folder '/'.
ifeq ($(and $(GSIM_REFERENCE),$(wildcard $(GSIM_REFERENCE)/.)),)
accuracy calibration:
	@echo "$@: there is no folder '$(GSIM_REFERENCE)' of recorded controllers; name it: make $@ GSIM_REFERENCE=FOLDER"
else
calibration:
	@scripts/setup.sh test calibrate
	@$(call build_into,release) --target gsim-black-box
	@build/bin/gsim-black-box --machines samples/machines --machines tests/accuracy/machines '$(GSIM_REFERENCE)'

accuracy:
	@scripts/setup.sh test
	@$(call build_into,release) --target gsim gsim-accuracy
	@build/bin/gsim-accuracy --gsim-run build/bin/gsim-run --machines samples/machines --machines tests/accuracy/machines --positions --summary '$(GSIM_REFERENCE)'
endif

coverage:
	@scripts/setup.sh test coverage
	@$(call build_into,coverage)
	@scripts/coverage.sh test build-coverage --parallel $(JOBS)
	@scripts/coverage.sh report build-coverage

docs: setup
	@$(call build_into,release) --target gsim
	@build/bin/gcode2lua --print-language > docs/language.md
	@scripts/services.py controller/module/rcs_services.def > docs/services.md

pictures: build
	@scripts/pictures.sh build

site:
	@scripts/setup.sh site
	@scripts/site.sh

fuzz:
	@scripts/setup.sh test clang
	@$(call build_into,sanitize) --target gsim-fuzz
	@JOBS='$(JOBS)' RECORD='$(RECORD)' tests/fuzz/run.sh build-sanitize '$(FUZZ_SECONDS)' '$(TARGET)'

format:
	@scripts/setup.sh lint
	@scripts/sources.sh | xargs -r clang-format -i

lint:
	@scripts/setup.sh lint
	@scripts/lint.sh format
	@scripts/lint.sh tidy

install: build
	@cmake --install build --prefix '$(PREFIX)'
	@cp build/install_manifest.txt build/installed.txt

uninstall:
	@scripts/uninstall.sh build/installed.txt

package:
	@scripts/setup.sh package step || scripts/setup.sh package
	@$(call build_into,release) --target product
	@$(MAKE) studio
	@scripts/package.sh build

clean:
	@rm -rf build build-debug build-sanitize build-coverage build-lint build-alone build-wasm build-wasm-sources studio/node_modules
