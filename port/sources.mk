# The library, for any build: include this file with NOOK set to the checkout, add -I$(NOOK)/src.
NOOK ?= .
NOOK_SOURCES := $(sort $(wildcard $(NOOK)/src/*/*.c))
