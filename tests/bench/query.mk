# query.mk -- build/query/bench: nook's queries beside those of peers that Debian has. For the Makefile.
# A peer that is not installed is left out, and said so; `make bench-query PEERS=` is nook alone.
PEERS ?= embree bullet ode fcl cgal
CXX := $(if $(filter default,$(origin CXX)),g++,$(CXX))
PEER_HEADER_embree := embree3/rtcore.h
PEER_HEADER_bullet := BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h
PEER_HEADER_ode := ode/ode.h
PEER_HEADER_fcl := fcl/geometry/bvh/BVH_model.h
PEER_HEADER_cgal := CGAL/AABB_tree.h
PEER_FLAGS_bullet := -isystem /usr/include/bullet
PEER_FLAGS_fcl := -isystem /usr/include/eigen3
PEER_LIBS_embree := -lembree3
PEER_LIBS_bullet := -lBulletCollision -lLinearMath
PEER_LIBS_ode := -lode
PEER_LIBS_fcl := -lfcl -lccd
PEER_LIBS_cgal := -lgmp -lmpfr
# Asked only when it matters.
PEERS_HERE := $(if $(filter bench% build/query/%,$(MAKECMDGOALS)),$(foreach p,$(PEERS),$(shell \
	echo '#include <$(PEER_HEADER_$(p))>' | $(CXX) -std=c++17 $(PEER_FLAGS_$(p)) -E -x c++ - >/dev/null 2>&1 && \
	echo $(p))))

build/query/%.o: tests/bench/query_%.cc tests/bench/query.mk
	@mkdir -p $(@D)
	$(Q)$(CXX) -std=c++17 -O2 -g -DNDEBUG -Wall -Wextra $(PEER_FLAGS_$*) -MMD -MP -c $< -o $@
# Two widths in one program: library and its side of the bench in one object each, of which one name is seen.
build/query/nook%.o: build/cc%/tests/bench/query_nook.o build/cc%/libnook.a
	@mkdir -p $(@D)
	$(Q)$(LD) -r $< --whole-archive build/cc$*/libnook.a -o $@
	$(Q)objcopy --keep-global-symbol=nook$*_engines $@
.SECONDARY: build/cc16/tests/bench/query_nook.o build/cc32/tests/bench/query_nook.o
QUERY_OBJECTS := $(patsubst %,build/query/%.o,nook32 nook16 $(PEERS_HERE)) \
	build/cc32/tests/bench/query_bench.o build/cc32/tests/bench/query_shapes.o
build/query/peers: FORCE # which are linked
	@mkdir -p $(@D); echo '$(PEERS_HERE)' | cmp -s - $@ || echo '$(PEERS_HERE)' >$@
build/query/bench: $(QUERY_OBJECTS) build/query/peers
	@echo "$@"
	$(Q)$(if $(PEERS_HERE),$(CXX),$(CC)) $(QUERY_OBJECTS) $(foreach p,$(PEERS_HERE),$(PEER_LIBS_$(p))) -lm -o $@

.PHONY: FORCE peers-missing
peers-missing:
	@$(foreach p,$(filter-out $(PEERS_HERE),embree bullet ode fcl cgal),\
		echo "SKIPPED: $(p): apt-get install lib$(p)-dev";) true
