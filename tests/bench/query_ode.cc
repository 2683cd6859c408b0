// query_ode.cc -- ODE's trimesh (OPCODE) for query_bench.
#include "query_bench.h"

#include <cmath>
#include <ode/ode.h>

namespace {
struct State {
    const shape *mesh;
    dTriMeshDataID data;
    dGeomID tree, ray;
};

void *prepare(const shape *mesh) {
    static const int once = dInitODE2(0);
    (void)once;
    dAllocateODEDataForThread(dAllocateMaskAll);
    return new State{mesh, nullptr, nullptr, nullptr};
}

void release(void *state) { delete static_cast<State *>(state); }

void build(void *state) {
    auto *s = static_cast<State *>(state);
    s->data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(s->data, s->mesh->G, sizeof(spot), int(s->mesh->nv), s->mesh->V,
                                int(3 * s->mesh->nt), 3 * sizeof(uint32_t));
    s->tree = dCreateTriMesh(nullptr, s->data, nullptr, nullptr, nullptr);
    s->ray = dCreateRay(nullptr, 3 * s->mesh->size);
    dGeomRaySetClosestHit(s->ray, 1);
}

void unbuild(void *state) {
    auto *s = static_cast<State *>(state);
    dGeomDestroy(s->ray);
    dGeomDestroy(s->tree);
    dGeomTriMeshDataDestroy(s->data);
}

void rays(void *state, const line *lines, uint32_t n, float *t) {
    auto *s = static_cast<State *>(state);
    for (uint32_t i = 0; i < n; i++) {
        const line &l = lines[i];
        dContactGeom contact;
        dGeomRaySet(s->ray, l.from.x, l.from.y, l.from.z, l.along.x, l.along.y, l.along.z);
        t[i] = dCollide(s->tree, s->ray, 1, &contact, sizeof contact) > 0 ? float(contact.depth) : INFINITY;
    }
}

engine make() {
    engine e{};
    e.name = "ODE";
    e.prepare = prepare;
    e.release = release;
    e.build = build;
    e.unbuild = unbuild;
    e.builds = true;
    e.rays = rays;
    return e;
}
} // namespace

const engine ode_engines[] = {make(), {}};
