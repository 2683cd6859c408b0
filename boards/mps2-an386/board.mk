# mps2-an386: Cortex-M4F at 25 MHz, emulated by qemu-system-arm -M mps2-an386. TICK is a tick of
# the port in tenths of a nanosecond, RAM what tests may fill.
BOARD_CPU := -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
BOARD_MACHINE := mps2-an386
BOARD_TICK := 400
BOARD_RAM := 4194304
BOARD_BITS := 16 32
BOARD_PARTS := tests
