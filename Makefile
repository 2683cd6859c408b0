# nook. `make help` says what can be made; README.md what it is.
# Everything that is built lies under build/, one folder a variant: a compiler, an index width, a purpose.
include port/sources.mk

CC := $(if $(filter default,$(origin CC)),gcc,$(CC))
CC := $(if $(shell command -v $(CC)),$(CC),cc)
CROSS := arm-none-eabi-
QEMU := qemu-system-arm
REQUIRE ?= 0
V ?= 0
Q := $(if $(filter 0,$(V)),@,) # V=1 shows the commands

WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion -Wstrict-prototypes
# No contraction: one rounding more or less would make a board differ from the PC.
FLAGS := -std=c99 $(WARNINGS) -O2 -g -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections \
	-Isrc -Iport -Ihost_sim -Itests -MMD -MP

LIBRARY := $(patsubst ./%,%,$(NOOK_SOURCES))
PROGRAM := $(sort $(wildcard host_sim/*.c))
TESTS := $(sort $(wildcard tests/*.c))

has = $(shell command -v $(1) 2>/dev/null)
# gcc, and clang where it is: both widths. A C compiler and make alone must do for `run` and `test`.
HOSTS := cc16 cc32 $(if $(call has,clang),clang16 clang32)
BOARDS := $(notdir $(patsubst %/board.mk,%,$(wildcard boards/*/board.mk)))

.PHONY: all run test test-boards test-host readme sanitize prove fuzz costs size stack symbols lint format format-check tools help clean bench bench-query
.DELETE_ON_ERROR:
all: build/nook build/nook16 build/cc32/libnook.a build/cc16/libnook.a ## build program and library, 32- and 16-bit indices

help: ## list these targets
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/  make \1#\2/p' Makefile tests/bench/*.mk | awk -F'#' '{printf "%-24s%s\n", $$1, $$2}'

# ---- variants: name, compiler, index bits, flags -------------------------------------------------
define variant
build/$(1)/%.o: %.c Makefile
	@mkdir -p $$(@D)
	$(Q)$(2) $(FLAGS) -DNOOK_INDEX_BITS=$(3) $(4) -c $$< -o $$@
build/$(1)/libnook.a: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY))
	@echo "$$@"
	@rm -f $$@
	$(Q)$(AR) rcs $$@ $$^
build/$(1)/nook: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY) $(PROGRAM))
	@echo "$$@"
	$(Q)$(2) $(4) $$^ -lm -o $$@
build/$(1)/tests.elf: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY) $(TESTS) port/posix/nook_port.c)
	@echo "$$@"
	$(Q)$(2) $(4) $$^ -o $$@
build/$(1)/prove_files: $(patsubst %.c,build/$(1)/%.o,tests/prove/files.c tests/prove/prove.c tests/check.c port/posix/nook_port.c \
		$(filter-out host_sim/main.c,$(PROGRAM))) build/$(1)/libnook.a
	@echo "$$@"
	$(Q)$(2) $(4) $$^ -lm -o $$@
build/$(1)/prove_%: build/$(1)/tests/prove/%.o $(patsubst %.c,build/$(1)/%.o,tests/prove/prove.c tests/prove/solids.c tests/prove/weights.c \
		tests/big.c tests/check.c port/posix/nook_port.c) build/$(1)/libnook.a
	@echo "$$@"
	$(Q)$(2) $(4) $$^ -lm -o $$@
endef
# Warnings are errors in `lint` only: a newer compiler than ours need not stop anybody.
SANITIZERS := -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
$(eval $(call variant,cc16,$(CC),16,))
$(eval $(call variant,cc32,$(CC),32,))
# For `symbols`: constant tables of pointers stay constant data, and no hardening that only PCs have.
$(eval $(call variant,flat16,$(CC),16,-fno-pic -fno-stack-protector -U_FORTIFY_SOURCE))
# For `prove`: as on a core without an FPU.
$(eval $(call variant,soft16,$(CC),16,-DNOOK_HAS_FPU=0))
$(eval $(call variant,clang16,clang,16,))
$(eval $(call variant,clang32,clang,32,))
$(eval $(call variant,asan16,$(CC),16,$(SANITIZERS)))
$(eval $(call variant,asan32,$(CC),32,$(SANITIZERS)))
$(eval $(call variant,clang-asan16,clang,16,$(SANITIZERS)))
$(eval $(call variant,clang-asan32,clang,32,$(SANITIZERS)))

# A board: the same tests, its startup and its memory, in each width it has room for. To add one, add a
# folder with board.mk and board.ld. A part is a program: tests/main.c with all tests, or with those of one
# file where RAM is small; what main does not call is not linked. The emulator ends by itself; the limit is
# for a hang.
BOARD_ELFS :=
BOARD_RUNS :=
define board_part
BOARD_ELFS += build/$(1)/$(2).elf
BOARD_RUNS += "timeout 600 $(QEMU) -M $$(BOARD_MACHINE) -display none -monitor none -serial null -chardev stdio,id=sh \
	-semihosting-config enable=on,target=native,chardev=sh -kernel build/$(1)/$(2).elf"
endef
define board_width
build/$(1)-$(2)/%: CPU := $$(BOARD_CPU) -DNOOK_TEST_RAM=$$(BOARD_RAM) -DTICK=$$(BOARD_TICK) -DNOOK_INDEX_BITS=$(2)
build/$(1)-$(2)/%.elf: LAYOUT := boards/$(1)/board.ld
build/$(1)-$(2)/%.o: %.c Makefile
	@mkdir -p $$(@D)
	$(Q)$(CROSS)gcc $(FLAGS) $$(CPU) -c $$< -o $$@
build/$(1)-$(2)/test_%/main.o: tests/main.c Makefile
	@mkdir -p $$(@D)
	$(Q)$(CROSS)gcc $(FLAGS) $$(CPU) -DNOOK_TEST_ROOM=test_$$* -c $$< -o $$@
$$(BOARD_PARTS:%=build/$(1)-$(2)/%.elf): build/$(1)-$(2)/%.elf: build/$(1)-$(2)/%/main.o \
		$(patsubst %.c,build/$(1)-$(2)/%.o,$(LIBRARY) $(filter-out tests/main.c,$(TESTS)) port/semihosting/nook_port.c boards/cortex_m/startup.c) \
		boards/$(1)/board.ld boards/cortex_m/sections.ld
	@echo "$$@"
	$(Q)$(CROSS)gcc $$(CPU) -nostartfiles --specs=nano.specs -Lboards/cortex_m -T $$(LAYOUT) -Wl,--gc-sections $$(filter %.o,$$^) -o $$@
	@! $(CROSS)nm $$@ | grep -E ' _*(sbrk|malloc|free|printf)(_r)?$$$$' || { echo "the heap or stdio got into $$@"; exit 1; }
build/$(1)-$(2)/costs.elf: $(patsubst %.c,build/$(1)-$(2)/%.o,$(LIBRARY) tests/bench/costs.c tests/check.c port/semihosting/nook_port.c \
		boards/cortex_m/startup.c) boards/$(1)/board.ld boards/cortex_m/sections.ld
	@echo "$$@"
	$(Q)$(CROSS)gcc $$(CPU) -nostartfiles --specs=nano.specs -Lboards/cortex_m -T $$(LAYOUT) -Wl,--gc-sections $$(filter %.o,$$^) -o $$@
$$(foreach part,$$(BOARD_PARTS),$$(eval $$(call board_part,$(1)-$(2),$$(part))))
endef
define board
include boards/$(1)/board.mk
$$(foreach bits,$$(BOARD_BITS),$$(eval $$(call board_width,$(1),$$(bits))))
COST_ELFS += build/$(1)-16/costs.elf
COST_RUNS += build/$(1)-16/costs.elf:$$(BOARD_MACHINE)
endef
COST_ELFS :=
COST_RUNS :=
$(foreach b,$(BOARDS),$(eval $(call board,$(b))))
CAN_CROSS := $(and $(call has,$(CROSS)gcc),$(call has,$(QEMU)),$(call has,timeout),\
	$(shell $(CROSS)gcc --specs=nano.specs -include string.h -E -x c /dev/null >/dev/null 2>&1 && echo yes))
ifeq ($(CAN_CROSS),)
BOARD_ELFS :=
BOARD_RUNS := "skip: the boards ($(BOARDS)): $(CROSS)gcc with newlib, $(QEMU) or timeout is missing; 'make tools' says how to get them"
endif

build/nook: build/cc32/nook
	@cp $< $@
build/nook16: build/cc16/nook
	@cp $< $@

# ---- the main job --------------------------------------------------------------------------------
run: build/nook ## make a sound and a defective mesh and check both
	build/nook make icosphere --triangles 320 -o build/sound.stl
	build/nook make icosphere --triangles 320 --defect hole -o build/hole.stl
	build/nook check build/sound.stl
	@echo build/nook check build/hole.stl; build/nook check build/hole.stl; test $$? -eq 1 # it must find the hole

# ---- tests ---------------------------------------------------------------------------------------
# Each item is a command that ends with "N passed, N failed, N skipped"; the script adds them up.
SUM := sh tests/tools/sum.sh $(REQUIRE)
HOST_SCRIPTS := $(sort $(wildcard tests/host/*.sh))
HOST_ELFS := $(foreach v,$(HOSTS),build/$(v)/tests.elf)
HOST_RUNS := $(foreach e,$(HOST_ELFS),"$(e)") $(foreach s,$(HOST_SCRIPTS),"NOOK=build/nook sh $(s)" "NOOK=build/nook16 sh $(s)") \
	"CC=$(CC) sh tests/tools/width_guard.sh" "CC=$(CC) sh tests/tools/readme_example.sh"
NO_CLANG := $(if $(call has,clang),,"skip: clang is not installed")

test: all $(HOST_ELFS) $(BOARD_ELFS) ## all tests on this machine, then on the boards
	@$(SUM) $(HOST_RUNS) $(NO_CLANG) $(BOARD_RUNS)

test-host: all $(HOST_ELFS) ## the tests on this machine only
	@$(SUM) $(HOST_RUNS) $(NO_CLANG)

test-boards: $(BOARD_ELFS) ## the tests on the emulated boards only
	@$(SUM) $(BOARD_RUNS)

readme: build/nook ## compile and run the firmware example of README.md
	@CC=$(CC) sh tests/tools/readme_example.sh

# clang's runtime is a package of its own, so having clang is not enough; asked only when it matters.
CLANG_CAN_SANITIZE := $(if $(filter sanitize,$(MAKECMDGOALS)),$(shell echo 'int main(void) { return 0; }' | \
	clang -fsanitize=address,undefined -x c - -o /dev/null 2>/dev/null && echo yes))
SANITIZED := asan16 asan32 $(if $(CLANG_CAN_SANITIZE),clang-asan16 clang-asan32)
NO_CLANG_RUNTIME := $(if $(CLANG_CAN_SANITIZE),,"skip: clang or its sanitizer runtime is not installed")

sanitize: $(foreach v,$(SANITIZED),build/$(v)/tests.elf build/$(v)/nook) ## tests and program under ASan and UBSan, gcc and clang
	@$(SUM) $(foreach v,$(SANITIZED),"build/$(v)/tests.elf" $(foreach s,$(HOST_SCRIPTS),"NOOK=build/$(v)/nook sh $(s)")) $(NO_CLANG_RUNTIME)

# ---- proofs by exhaustion --------------------------------------------------------------------------
PROVE := cc16/prove_exact soft16/prove_exact cc16/prove_worlds cc32/prove_worlds cc16/prove_tables asan16/prove_tables asan16/prove_faults \
	cc16/prove_faults cc16/prove_edits cc16/prove_spoiled asan16/prove_spoiled cc16/prove_hull cc16/prove_simplify cc16/prove_levels cc32/prove_levels cc32/prove_files asan16/prove_files \
	cc16/prove_pairs cc16/prove_queries cc16/prove_nearest cc16/prove_trees cc32/prove_trees asan16/prove_queries asan16/prove_nearest \
	asan16/prove_trees cc16/prove_orient asan16/prove_orient
PROVE_SMALL := $(addprefix asan16/prove_,spoiled queries nearest trees orient)
PROVE_RUNS := $(foreach p,$(filter-out %_tables %_files $(PROVE_SMALL),$(PROVE)),"build/$(p)") \
	$(foreach p,$(filter %_files,$(PROVE)),"build/$(p) $(MESHES)") $(foreach p,$(PROVE_SMALL),"build/$(p) small") "build/cc16/prove_tables large" "build/asan16/prove_tables small" \
	"build/cc16/prove_tables pairs"
GUARDS := python3 tests/tools/guards.py $(CROSS) mps2-an386 -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16 $(FLAGS) -DTICK=400
MUTANTS ?= 24
# Folders of mesh files for prove_files to walk and edit.
MESHES ?=
SECONDS ?= 60

prove: $(addprefix build/,$(PROVE)) ## all small worlds, all tables, all single faults, all branches, exact signs, guards, mutants: figures
	@$(SUM) "CC=$(CC) python3 tests/tools/coverage.py" "python3 tests/tools/decisions.py" $(PROVE_RUNS) \
		$(if $(CAN_CROSS),"$(GUARDS)","skip: what guards cost; the cross compiler or the emulator is missing") \
		"python3 tests/tools/mutate.py --sample $(MUTANTS) --seed 1 --at-least 70"

fuzz: build/nook ## the fuzz targets, SECONDS=60 in all; needs clang and its fuzzer runtime
	@$(SUM) "sh tests/fuzz/run.sh $(SECONDS)"

# ---- what the library costs and what it leans on ---------------------------------------------------
CORES := m0 m4f
FLAGS_m0 := -mcpu=cortex-m0 -mthumb
FLAGS_m4f := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
define core
build/$(1)/%.o: %.c Makefile
	@mkdir -p $$(@D)
	$(Q)$(CROSS)gcc $(FLAGS) $(FLAGS_$(1)) -fstack-usage -fcallgraph-info=su,da -c $$< -o $$@
build/$(1)/objects: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY))
	@touch $$@
endef
$(foreach c,$(CORES),$(eval $(call core,$(c))))

size: $(foreach c,$(CORES),build/$(c)/objects) ## code bytes on Cortex-M0 and M4F; code lines of each room; fails past a ceiling
	@$(foreach c,$(CORES),python3 tests/tools/size.py $(CROSS) $(c) build/$(c);) python3 tests/tools/lines.py

stack: $(foreach c,$(CORES),build/$(c)/objects) ## worst-case stack of every public function; fails above 1,020 bytes
	@$(foreach c,$(CORES),python3 tests/tools/stack.py --limit 1020 --cross $(CROSS) --name $(c) --objects build/$(c) -- $(FLAGS_$(c)) &&) true

UPDATE ?= 0
COSTS = python3 tests/tools/costs.py --cross $(CROSS) $(foreach c,$(CORES),--cores '$(c):$(FLAGS_$(c))') --boards $(COST_RUNS)
costs: $(foreach c,$(CORES),build/$(c)/objects) $(COST_ELFS) ## code, stack and instructions against tests/costs.txt; UPDATE=1 rewrites it
	@$(if $(filter 1,$(UPDATE)),$(COSTS) --update,$(SUM) "$(COSTS)")

symbols: $(foreach c,$(CORES),build/$(c)/objects) $(patsubst %.c,build/flat16/%.o,$(LIBRARY)) ## what the library exports and needs; fails on anything foreign
	@sh tests/tools/symbols.sh nm $(patsubst %.c,build/flat16/%.o,$(LIBRARY))
	@$(foreach c,$(CORES),sh tests/tools/symbols.sh $(CROSS)nm $(patsubst %.c,build/$(c)/%.o,$(LIBRARY)) &&) true

# ---- tidiness --------------------------------------------------------------------------------------
C_FILES = $(shell find src host_sim port boards tests -name '*.[ch]')
lint: ## warnings as errors (gcc and clang, both widths, C++), clang-tidy, cppcheck
	@CC=$(CC) REQUIRE=$(REQUIRE) sh tests/tools/lint.sh $(FLAGS)

format: ## lay out all C files
	clang-format -i $(C_FILES)

format-check: ## fail if `make format` would change anything
	clang-format --dry-run --Werror $(C_FILES)

bench: bench-query bench-simplify ## and nook_link beside Draco's CornerTable, exact signs by kind of case; needs g++ and libdraco-dev
	sh tests/bench/run.sh

include tests/bench/query.mk
include tests/bench/orient.mk
include tests/bench/simplify.mk
BENCH ?=
bench-query: build/query/bench peers-missing ## queries beside Embree, Bullet, ODE, FCL, CGAL; BENCH="only=rays:pipe20k x.stl"
	build/query/bench $(BENCH)

tools: ## say, and as root on Debian install, what boards and lint need
	sh tests/tools/tools.sh

clean: ## remove build/
	rm -rf build

-include $(shell find build -name '*.d' 2>/dev/null)
