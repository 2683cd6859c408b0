// simplify_bench.cc -- how long fewer triangles take, and how far they are from before: nook, CGAL's Garland-Heckbert, and
// meshoptimizer, each to a tenth. Rounds are interleaved, times are of the processor, the least of the rounds. Distances are those of
// 100,000 places spread evenly over one surface from the other, the mean of both directions, and the largest.
#include "query_bench.h"

extern "C" {
#include "nook.h"
}
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <vector>
#ifdef WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif
#ifdef WITH_CGAL
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#endif

namespace {
struct Soup {
    std::vector<nook_point> G;
    std::vector<uint32_t> V;
};

double seconds() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

void must(nook_status status) {
    if (status == NOOK_OK) return;
    printf("nook: %s\n", nook_status_name(status));
    abort();
}

// A linked mesh with a tree over it.
struct Linked {
    std::vector<nook_point> G;
    std::vector<nook_index> V, O, C, order;
    std::vector<nook_boxes> boxes;
    nook_mesh mesh;
    nook_view view;
    nook_bvh bvh;
    nook_report report;

    explicit Linked(const Soup &s) : G(s.G), V(s.V.begin(), s.V.end()), O(V.size()), C(G.size()), view(), bvh(), report() {
        must(nook_mesh_init(&mesh, G.data(), V.data(), O.data(), C.data(), uint32_t(G.size()),
                            uint32_t(V.size() / 3)));
        mesh.nv = mesh.max_nv;
        mesh.nt = mesh.max_nt;
        must(nook_link(&mesh, nullptr, nullptr, nullptr, &report, nullptr));
    }

    void plant() {
        view = nook_view_of(&mesh);
        boxes.resize(NOOK_BVH_GROUPS(mesh.nt));
        order.resize(mesh.nt);
        must(nook_bvh_build(&bvh, &view, boxes.data(), order.data(), nullptr));
    }

    Soup soup() const { return {{G.begin(), G.begin() + mesh.nv}, {V.begin(), V.begin() + 3 * mesh.nt}}; }

    double distance(nook_point p) const {
        nook_closest closest;
        must(nook_closest_point(&closest, &bvh, p));
        return double(closest.distance);
    }
};

nook_point at(const Soup &s, size_t t, double u, double v) {
    const nook_point &a = s.G[s.V[3 * t]], &b = s.G[s.V[3 * t + 1]], &c = s.G[s.V[3 * t + 2]];
    const auto blend = [&](float x, float y, float z) {
        return float(double(x) + u * double(y - x) + v * double(z - x));
    };
    return {blend(a.x, b.x, c.x), blend(a.y, b.y, c.y), blend(a.z, b.z, c.z)};
}

void one_way(const Soup &from, const Linked &to, double &mean, double &most) {
    const size_t places = 100000;
    std::vector<double> area;
    double all = 0, sum = 0;
    uint32_t state = 1;
    const auto lot = [&] { return double((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0; };
    for (size_t t = 0; t < from.V.size() / 3; t++) {
        const nook_point a = at(from, t, 0, 0), b = at(from, t, 1, 0), c = at(from, t, 0, 1);
        const nook_point n = nook_cross(nook_sub(b, a), nook_sub(c, a));
        area.push_back(all += std::sqrt(double(nook_dot(n, n))));
    }
    for (size_t i = 0; i < places; i++) {
        const double where = all * (double(i) + lot()) / double(places);
        const size_t t = std::min(size_t(std::lower_bound(area.begin(), area.end(), where) - area.begin()),
                                  area.size() - 1);
        double u = lot(), v = lot();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const double d = to.distance(at(from, t, u, v));
        sum += d;
        most = std::max(most, d);
    }
    for (const nook_point &p : from.G) most = std::max(most, to.distance(p));
    mean += 0.5 * sum / double(places);
}

// Only vertices that are used.
Soup packed(const Soup &s) {
    std::vector<uint32_t> name(s.G.size(), NOOK_NONE);
    Soup p;
    for (const uint32_t v : s.V) {
        if (name[v] == NOOK_NONE) {
            name[v] = uint32_t(p.G.size());
            p.G.push_back(s.G[v]);
        }
        p.V.push_back(name[v]);
    }
    return p;
}

Soup by_nook(const Soup &s, uint32_t target, double &time, bool outside, bool bounded) {
    Linked m(s);
    nook_simplify_goal goal{};
    std::vector<float> deviation(s.G.size());
    goal.triangles = target;
    goal.outside = outside;
    goal.error = 1e30f;
    if (bounded) goal.deviation = deviation.data();
    time = -seconds();
    nook_simplify_state state;
    const nook_status status = nook_simplify(&state, &m.mesh, &goal, nullptr);
    time += seconds();
    if (status != NOOK_OK) printf("(%s) ", nook_status_name(status));
    return m.soup();
}

#ifdef WITH_MESHOPTIMIZER
Soup by_meshoptimizer(const Soup &s, uint32_t target, double &time) {
    Soup r{s.G, std::vector<uint32_t>(s.V.size())};
    time = -seconds();
    r.V.resize(meshopt_simplify(r.V.data(), s.V.data(), s.V.size(), &s.G[0].x, s.G.size(), sizeof(nook_point),
                                3 * target, 1e9f, 0, nullptr));
    time += seconds();
    return packed(r);
}
#endif

#ifdef WITH_CGAL
namespace SMS = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// It stops at a number of edges: of as many triangles closed meshes have half as many more, others some for the border.
Soup by_cgal(const Soup &s, uint32_t target, double &time) {
    Mesh m;
    for (const nook_point &p : s.G) m.add_vertex({double(p.x), double(p.y), double(p.z)});
    for (size_t c = 0; c < s.V.size(); c += 3)
        m.add_face(Mesh::Vertex_index(s.V[c]), Mesh::Vertex_index(s.V[c + 1]),
                   Mesh::Vertex_index(s.V[c + 2]));
    time = -seconds();
    SMS::GarlandHeckbert_plane_policies<Mesh, Kernel> policies(m);
    SMS::edge_collapse(
        m, SMS::Count_stop_predicate<Mesh>(3 * target / 2),
        CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
    time += seconds();
    m.collect_garbage();
    Soup r;
    for (const auto v : m.vertices())
        r.G.push_back({float(m.point(v).x()), float(m.point(v).y()), float(m.point(v).z())});
    for (const auto f : m.faces())
        for (const auto v : CGAL::vertices_around_face(m.halfedge(f), m)) r.V.push_back(v.idx());
    return r;
}
#endif

struct Way {
    const char *name;
    std::function<Soup(const Soup &, uint32_t, double &)> run;
    double least = 1e30;
    Soup result = {};
};

void compare(const shape &mesh) {
    Soup s;
    for (uint32_t v = 0; v < mesh.nv; v++) s.G.push_back({mesh.G[v].x, mesh.G[v].y, mesh.G[v].z});
    s.V.assign(mesh.V, mesh.V + 3 * size_t(mesh.nt));
    const uint32_t target = mesh.nt / 10;
    Linked before(s);
    if (before.report.border_edges + before.report.matched_edges != before.report.edges) {
        printf("%s: left out, as it is no oriented manifold\n", mesh.name);
        return;
    }
    std::vector<Way> ways;
    ways.push_back(
        {"nook", [](const Soup &m, uint32_t n, double &t) { return by_nook(m, n, t, false, false); }});
    ways.push_back({"nook, bounded",
                    [](const Soup &m, uint32_t n, double &t) { return by_nook(m, n, t, false, true); }});
    if (mesh.closed)
        ways.push_back({"nook, outside",
                        [](const Soup &m, uint32_t n, double &t) { return by_nook(m, n, t, true, false); }});
#ifdef WITH_MESHOPTIMIZER
    ways.push_back({"meshoptimizer", by_meshoptimizer});
#endif
#ifdef WITH_CGAL
    ways.push_back({"CGAL G-H", by_cgal});
#endif
    for (int round = 0; round < 5; round++)
        for (Way &w : ways) {
            double time = 0;
            w.result = w.run(s, target, time);
            w.least = std::min(w.least, time);
        }
    before.plant();
    printf("%s, %u triangles to %u          ns/triangle       mean        most   (of the size %g)\n",
           mesh.name, mesh.nt, target, double(mesh.size));
    for (const Way &w : ways) {
        double mean = 0, most = 0;
        Linked after(w.result);
        after.plant();
        one_way(s, after, mean, most);
        one_way(w.result, before, mean, most);
        printf("  %-14s %6u triangles %14.0f %12.3e %11.3e\n", w.name, after.mesh.nt, 1e9 * w.least / mesh.nt,
               mean, most);
    }
}
} // namespace

int main(int argc, char **argv) {
    static const char *const usual[] = {"bumpy20k", "sheet20k", "pipe20k", "gear5k"};
    printf("state of nook_simplify: %zu bytes, nothing else\n", sizeof(nook_simplify_state));
    for (int i = 1; i < std::max(argc, 5); i++) {
        const char *name = argc > 1 ? argv[i] : usual[i - 1];
        shape mesh;
        if (!shape_make(&mesh, name) && !shape_read(&mesh, name)) {
            printf("no mesh: %s (a name in query_shapes.c, or a binary STL)\n", name);
            return 1;
        }
        compare(mesh);
        shape_free(&mesh);
        if (i + 1 == argc) break;
    }
    return 0;
}
