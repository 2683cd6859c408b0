// query_embree.cc -- Embree 3 for query_bench: one thread, rtcIntersect1 in its normal (SIMD) mode.
#include "query_bench.h"

#include <cmath>
#include <cstdlib>
#include <embree3/rtcore.h>

namespace {
struct State {
    const shape *mesh;
    RTCDevice device;
    RTCScene scene;
    ssize_t bytes; // that Embree says it holds
};

bool count(void *state, ssize_t bytes, bool) {
    static_cast<State *>(state)->bytes += bytes;
    return true;
}

void *prepare(const shape *mesh) {
    auto *s = new State{mesh, rtcNewDevice("threads=1"), nullptr, 0};
    if (!s->device) std::abort();
    rtcSetDeviceMemoryMonitorFunction(s->device, count, s);
    return s;
}

void release(void *state) {
    rtcReleaseDevice(static_cast<State *>(state)->device);
    delete static_cast<State *>(state);
}

template <RTCBuildQuality quality, int flags> void build(void *state) {
    auto *s = static_cast<State *>(state);
    const shape *m = s->mesh;
    s->scene = rtcNewScene(s->device);
    rtcSetSceneFlags(s->scene, RTCSceneFlags(flags));
    rtcSetSceneBuildQuality(s->scene, quality);
    RTCGeometry geometry = rtcNewGeometry(s->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, m->G, 0, sizeof(spot),
                               m->nv);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, m->V, 0, 12, m->nt);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(s->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(s->scene);
    if (rtcGetDeviceError(s->device) != RTC_ERROR_NONE) std::abort();
}

void unbuild(void *state) { rtcReleaseScene(static_cast<State *>(state)->scene); }

size_t kept(void *state, size_t) { return size_t(static_cast<State *>(state)->bytes); }

void rays(void *state, const line *lines, uint32_t n, float *t) {
    RTCScene scene = static_cast<State *>(state)->scene;
    for (uint32_t i = 0; i < n; i++) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit r;
        r.ray = {lines[i].from.x,
                 lines[i].from.y,
                 lines[i].from.z,
                 0,
                 lines[i].along.x,
                 lines[i].along.y,
                 lines[i].along.z,
                 0,
                 INFINITY,
                 ~0u,
                 0,
                 0};
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &r);
        t[i] = r.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : r.ray.tfar;
    }
}

engine make(const char *name, void (*build)(void *), bool casts) {
    engine e{};
    e.name = name;
    e.prepare = prepare;
    e.release = release;
    e.build = build;
    e.unbuild = unbuild;
    e.builds = true;
    e.kept = kept;
    if (casts) e.rays = rays;
    return e;
}
} // namespace

const engine embree_engines[] = {
    make("Embree-med", build<RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_NONE>, true),
    make("Embree-rob", build<RTC_BUILD_QUALITY_MEDIUM, RTC_SCENE_FLAG_COMPACT | int(RTC_SCENE_FLAG_ROBUST)>,
         true),
    make("Embree-low", build<RTC_BUILD_QUALITY_LOW, RTC_SCENE_FLAG_NONE>, false),
    make("Embree-high", build<RTC_BUILD_QUALITY_HIGH, RTC_SCENE_FLAG_NONE>, true),
    {}};
