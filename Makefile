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
# gcc, and clang where it is: both widths.
HOSTS := cc16 cc32 $(if $(call has,clang),clang16 clang32)
BOARDS := $(notdir $(patsubst %/board.mk,%,$(wildcard boards/*/board.mk)))

.PHONY: all run test test-boards test-host sanitize size stack symbols lint format format-check tools help clean bench
all: build/nook build/nook16 ## build the program with 32- and with 16-bit indices

help: ## list these targets
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/  make \1#\2/p' Makefile | awk -F'#' '{printf "%-24s%s\n", $$1, $$2}'

# ---- variants: name, compiler, index bits, flags -------------------------------------------------
define variant
build/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$(Q)$(2) $(FLAGS) -DNOOK_INDEX_BITS=$(3) $(4) -c $$< -o $$@
build/$(1)/nook: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY) $(PROGRAM))
	@echo "$$@"
	$(Q)$(2) $(4) $$^ -lm -o $$@
build/$(1)/tests.elf: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY) $(TESTS) port/posix/nook_port.c)
	@echo "$$@"
	$(Q)$(2) $(4) $$^ -o $$@
endef
SANITIZERS := -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
$(eval $(call variant,cc16,$(CC),16,))
$(eval $(call variant,cc32,$(CC),32,))
$(eval $(call variant,flat16,$(CC),16,-fno-pic)) # constant tables of pointers stay constant data
$(eval $(call variant,clang16,clang,16,))
$(eval $(call variant,clang32,clang,32,))
$(eval $(call variant,asan16,$(CC),16,$(SANITIZERS)))
$(eval $(call variant,asan32,$(CC),32,$(SANITIZERS)))

# A board: the same tests, its startup and its memory. The emulator ends by itself; the limit is for a hang.
define board
include boards/$(1)/board.mk
build/$(1)/%.o: CPU := $$(BOARD_CPU) -DNOOK_TEST_RAM=$$(BOARD_RAM)
build/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$(Q)$(CROSS)gcc $(FLAGS) $$(CPU) -c $$< -o $$@
build/$(1)/tests.elf: CPU := $$(BOARD_CPU)
build/$(1)/tests.elf: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY) $(TESTS) port/semihosting/nook_port.c boards/cortex_m/startup.c)
	@echo "$$@"
	$(Q)$(CROSS)gcc $$(CPU) -nostartfiles --specs=nano.specs -Lboards/cortex_m -T boards/$(1)/board.ld -Wl,--gc-sections $$^ -o $$@
	@! $(CROSS)nm $$@ | grep -E ' _sbrk| malloc' || { echo "the heap got into $$@"; rm -f $$@; exit 1; }
RUN_$(1) := timeout 600 $(QEMU) -M $$(BOARD_MACHINE) -display none -monitor none -serial null -chardev stdio,id=sh \
	-semihosting-config enable=on,target=native,chardev=sh -kernel build/$(1)/tests.elf
endef
$(foreach b,$(BOARDS),$(eval $(call board,$(b))))

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
HOST_RUNS := $(foreach v,$(HOSTS),"build/$(v)/tests.elf") $(foreach s,$(sort $(wildcard tests/host/*.sh)),"sh $(s)") \
	"CC=$(CC) sh tests/tools/width_guard.sh" "CC=$(CC) sh tests/tools/readme_example.sh"
CAN_CROSS := $(and $(call has,$(CROSS)gcc),$(call has,$(QEMU)))
NO_CROSS := "skip: the boards ($(BOARDS)): no $(CROSS)gcc or no $(QEMU); 'make tools' says how to get them"
BOARD_RUNS := $(if $(CAN_CROSS),$(foreach b,$(BOARDS),"$(RUN_$(b))"),$(NO_CROSS))
NO_CLANG := $(if $(call has,clang),,"skip: clang is not installed")
BOARD_ELFS := $(if $(CAN_CROSS),$(foreach b,$(BOARDS),build/$(b)/tests.elf))

test: all $(foreach v,$(HOSTS),build/$(v)/tests.elf) $(BOARD_ELFS) ## all tests on this machine, then on the boards
	@$(SUM) $(HOST_RUNS) $(NO_CLANG) $(BOARD_RUNS)

test-host: all $(foreach v,$(HOSTS),build/$(v)/tests.elf) ## the tests on this machine only
	@$(SUM) $(HOST_RUNS) $(NO_CLANG)

test-boards: $(BOARD_ELFS) ## the tests on the emulated boards only
	@$(SUM) $(BOARD_RUNS)

sanitize: build/asan16/tests.elf build/asan32/tests.elf build/asan16/nook build/asan32/nook ## tests and program under ASan and UBSan
	@$(SUM) build/asan16/tests.elf build/asan32/tests.elf \
		$(foreach s,$(sort $(wildcard tests/host/*.sh)),"NOOK=build/asan32/nook sh $(s)" "NOOK=build/asan16/nook sh $(s)")

# ---- what the library costs and what it leans on ---------------------------------------------------
CORES := m0 m4f
FLAGS_m0 := -mcpu=cortex-m0 -mthumb
FLAGS_m4f := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
define core
build/$(1)/%.o: %.c
	@mkdir -p $$(@D)
	$(Q)cd $$(@D) && $(CROSS)gcc $(FLAGS:-I%=-I$(CURDIR)/%) $(FLAGS_$(1)) -fstack-usage -fcallgraph-info=su -c $(CURDIR)/$$< -o $$(@F)
build/$(1)/objects: $(patsubst %.c,build/$(1)/%.o,$(LIBRARY))
	@touch $$@
endef
$(foreach c,$(CORES),$(eval $(call core,$(c))))

size: $(foreach c,$(CORES),build/$(c)/objects) ## code bytes on Cortex-M0 and M4F; code lines of each room
	@$(foreach c,$(CORES),python3 tests/tools/size.py $(CROSS) $(c) build/$(c);) python3 tests/tools/lines.py

stack: $(foreach c,$(CORES),build/$(c)/objects) ## worst-case stack of every public function; fails above 512 bytes
	@$(foreach c,$(CORES),python3 tests/tools/stack.py --limit 512 --cross $(CROSS) --name $(c) --objects build/$(c) -- $(FLAGS_$(c)) &&) true

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

bench: ## nook_link beside Draco's CornerTable; needs g++ and libdraco-dev
	sh tests/bench/run.sh

tools: ## say, and as root on Debian install, what boards and lint need
	sh tests/tools/tools.sh

clean: ## remove build/
	rm -rf build

-include $(shell find build -name '*.d' 2>/dev/null)
