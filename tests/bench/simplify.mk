# simplify.mk -- build/simplify/bench: nook_simplify beside Garland and Heckbert's in CGAL and meshoptimizer's, as Debian has
# them (libcgal-dev libeigen3-dev libmeshoptimizer-dev). For the Makefile. A peer that is not installed is left out, and said so.
SIMPLIFY_CXX := $(if $(filter default,$(origin CXX)),g++,$(CXX))
SIMPLIFY_HAS = $(shell echo '\#include <$(1)>' | $(SIMPLIFY_CXX) -std=c++17 -isystem /usr/include/eigen3 -E -x c++ - >/dev/null 2>&1 && echo yes)
SIMPLIFY_ASKED := $(filter bench-simplify build/simplify/%,$(MAKECMDGOALS))
SIMPLIFY_CGAL := $(if $(SIMPLIFY_ASKED),$(and $(call SIMPLIFY_HAS,CGAL/Surface_mesh.h),$(call SIMPLIFY_HAS,Eigen/Dense)))
SIMPLIFY_MESHOPT := $(if $(SIMPLIFY_ASKED),$(call SIMPLIFY_HAS,meshoptimizer.h))

build/simplify/bench.o: tests/bench/simplify_bench.cc tests/bench/simplify.mk
	@mkdir -p $(@D)
	$(Q)$(SIMPLIFY_CXX) -std=c++17 -O2 -g -DNDEBUG -Wall -Wextra -isystem /usr/include/eigen3 -Isrc -DNOOK_INDEX_BITS=32 \
		$(if $(SIMPLIFY_CGAL),-DWITH_CGAL) $(if $(SIMPLIFY_MESHOPT),-DWITH_MESHOPTIMIZER) -MMD -MP -c $< -o $@
build/simplify/bench: build/simplify/bench.o build/cc32/tests/bench/query_shapes.o build/cc32/libnook.a
	@echo "$@"
	$(Q)$(SIMPLIFY_CXX) $^ $(if $(SIMPLIFY_CGAL),-lgmp -lmpfr) $(if $(SIMPLIFY_MESHOPT),-lmeshoptimizer) -lm -o $@

.PHONY: bench-simplify
bench-simplify: build/simplify/bench ## nook_simplify beside CGAL's Garland-Heckbert and meshoptimizer; BENCH="bumpy20k x.stl"
	@$(if $(SIMPLIFY_CGAL),,echo "SKIPPED: CGAL: apt-get install libcgal-dev libeigen3-dev";) true
	@$(if $(SIMPLIFY_MESHOPT),,echo "SKIPPED: meshoptimizer: apt-get install libmeshoptimizer-dev";) true
	build/simplify/bench $(BENCH)
