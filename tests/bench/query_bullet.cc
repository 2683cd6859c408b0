// query_bullet.cc -- Bullet's btBvhTriangleMeshShape, quantised, for query_bench.
#include "query_bench.h"

#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cmath>

namespace {
struct State {
    btTriangleIndexVertexArray arrays;
    btBvhTriangleMeshShape *tree;
    float reach; // from any origin through the whole box
    static_assert(sizeof(btScalar) == sizeof(float), "Debian's Bullet is single precision");
};

struct First : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    btScalar reportHit(const btVector3 &, btScalar fraction, int, int) override { return fraction; }
};

void *prepare(const shape *m) {
    return new State{{int(m->nt), reinterpret_cast<int *>(m->V), 12, int(m->nv), &m->G[0].x, sizeof(spot)},
                     nullptr,
                     3 * m->size};
}

void release(void *state) { delete static_cast<State *>(state); }

void build(void *state) {
    auto *s = static_cast<State *>(state);
    s->tree = new btBvhTriangleMeshShape(&s->arrays, true);
}

void unbuild(void *state) { delete static_cast<State *>(state)->tree; }

void rays(void *state, const line *lines, uint32_t n, float *t) {
    auto *s = static_cast<State *>(state);
    for (uint32_t i = 0; i < n; i++) {
        const btVector3 from(lines[i].from.x, lines[i].from.y, lines[i].from.z);
        const btVector3 along(lines[i].along.x, lines[i].along.y, lines[i].along.z);
        First first(from, from + along * s->reach);
        s->tree->performRaycast(&first, first.m_from, first.m_to);
        t[i] = first.m_hitFraction < 1 ? first.m_hitFraction * s->reach : INFINITY;
    }
}

engine make() {
    engine e{};
    e.name = "Bullet";
    e.prepare = prepare;
    e.release = release;
    e.build = build;
    e.unbuild = unbuild;
    e.builds = true;
    e.rays = rays;
    return e;
}
} // namespace

const engine bullet_engines[] = {make(), {}};
