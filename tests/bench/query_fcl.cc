// query_fcl.cc -- FCL's tree of oriented boxes and swept spheres for query_bench: building only.
#include "query_bench.h"

#include <fcl/geometry/bvh/BVH_model.h>

namespace {
using Model = fcl::BVHModel<fcl::OBBRSS<float>>;

struct State {
    std::vector<fcl::Vector3<float>> points;
    std::vector<fcl::Triangle> triangles;
    std::unique_ptr<Model> tree;
};

void *prepare(const shape *m) {
    auto *s = new State;
    for (uint32_t v = 0; v < m->nv; v++) s->points.emplace_back(m->G[v].x, m->G[v].y, m->G[v].z);
    for (uint32_t c = 0; c < 3 * m->nt; c += 3) s->triangles.emplace_back(m->V[c], m->V[c + 1], m->V[c + 2]);
    return s;
}

void release(void *state) { delete static_cast<State *>(state); }

void build(void *state) {
    auto *s = static_cast<State *>(state);
    s->tree.reset(new Model);
    s->tree->beginModel(int(s->triangles.size()), int(s->points.size()));
    s->tree->addSubModel(s->points, s->triangles);
    s->tree->endModel();
}

void unbuild(void *state) { static_cast<State *>(state)->tree.reset(); }

size_t kept(void *state, size_t grown) { // without its copy of the mesh
    auto *s = static_cast<State *>(state);
    return grown - s->points.size() * sizeof s->points[0] - s->triangles.size() * sizeof s->triangles[0];
}

engine make() {
    engine e{};
    e.name = "FCL-float";
    e.prepare = prepare;
    e.release = release;
    e.build = build;
    e.unbuild = unbuild;
    e.builds = true;
    e.kept = kept;
    return e;
}
} // namespace

const engine fcl_engines[] = {make(), {}};
