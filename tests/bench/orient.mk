# orient.mk -- nook's orientation held against CGAL's on random solids; on request, as it needs libcgal-dev. For the Makefile.
build/orient_cgal: tests/bench/orient_cgal.cc tests/bench/orient.mk build/cc32/libnook.a
	@echo "$@"
	$(Q)$(CXX) -std=c++17 -O2 -g -DNDEBUG -Wall -Wextra -Isrc -DNOOK_INDEX_BITS=32 $< build/cc32/libnook.a -lgmp -lmpfr -o $@

SOLIDS ?= 1000
.PHONY: orient-cgal
orient-cgal: build/orient_cgal ## SOLIDS=1000 random solids: nook and CGAL must orient them alike; needs libcgal-dev
	@$(SUM) "build/orient_cgal $(SOLIDS)"
