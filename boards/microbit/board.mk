# microbit: Cortex-M0 at 16 MHz without an FPU, emulated by qemu-system-arm -M microbit. RAM is little, so each test
# file is a program of its own.
BOARD_CPU := -mcpu=cortex-m0 -mthumb -mfloat-abi=soft
BOARD_MACHINE := microbit
BOARD_TICK := 625
BOARD_RAM := 16384
BOARD_BITS := 16
BOARD_PARTS := $(patsubst tests/%.c,%,$(sort $(wildcard tests/test_*.c)))
