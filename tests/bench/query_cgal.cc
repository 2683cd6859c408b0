// query_cgal.cc -- CGAL for query_bench: AABB_tree over triangles (rays, closest points) with exact
// predicates and with plain doubles, Side_of_triangle_mesh, Polygon_mesh_processing's self-intersections.
#include "query_bench.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <cmath>
#include <memory>
#include <vector>

namespace {
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Plain = CGAL::Simple_cartesian<double>;

// ---- a tree over triangles ----------------------------------------------------------------------------
template <class K> struct Tree {
    using Triangles = std::vector<typename K::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<K, typename Triangles::const_iterator>;
    using Type = CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive>>;
    Triangles triangles;
    std::unique_ptr<Type> tree;

    static Tree &of(void *state) { return *static_cast<Tree *>(state); }

    static void *prepare(const shape *m) {
        auto *s = new Tree;
        const auto corner = [m](uint32_t c) {
            const spot &p = m->G[m->V[c]];
            return typename K::Point_3(p.x, p.y, p.z);
        };
        for (uint32_t c = 0; c < 3 * m->nt; c += 3)
            s->triangles.emplace_back(corner(c), corner(c + 1), corner(c + 2));
        return s;
    }

    static void release(void *state) { delete &of(state); }

    static void build(void *state) {
        Tree &s = of(state);
        s.tree.reset(new Type(s.triangles.begin(), s.triangles.end()));
        s.tree->build();
        s.tree->accelerate_distance_queries();
    }

    static void unbuild(void *state) { of(state).tree.reset(); }

    static void rays(void *state, const line *lines, uint32_t n, float *t) {
        const Type &tree = *of(state).tree;
        for (uint32_t i = 0; i < n; i++) {
            const line &l = lines[i];
            const typename K::Point_3 from(l.from.x, l.from.y, l.from.z);
            const typename K::Vector_3 along(l.along.x, l.along.y, l.along.z);
            t[i] = INFINITY;
            if (const auto hit = tree.first_intersection(typename K::Ray_3(from, from + along))) {
                if (const auto *p = boost::get<typename K::Point_3>(&hit->first))
                    t[i] = float(std::sqrt(CGAL::to_double(CGAL::squared_distance(from, *p))));
                else if (const auto *edge = boost::get<typename K::Segment_3>(&hit->first))
                    t[i] = float(std::sqrt(CGAL::to_double(CGAL::squared_distance(from, *edge))));
            }
        }
    }

    static void closest(void *state, const spot *at, uint32_t n, gap *gaps) {
        const Type &tree = *of(state).tree;
        for (uint32_t i = 0; i < n; i++) {
            const typename K::Point_3 p(at[i].x, at[i].y, at[i].z);
            const double d = std::sqrt(CGAL::to_double(CGAL::squared_distance(p, tree.closest_point(p))));
            gaps[i] = {d, d, d};
        }
    }
};

// ---- a mesh with neighbours ---------------------------------------------------------------------------
struct Faces {
    using Mesh = CGAL::Surface_mesh<Epick::Point_3>;
    using Side = CGAL::Side_of_triangle_mesh<Mesh, Epick>;
    Mesh mesh;
    std::unique_ptr<Side> tree;

    static Faces &of(void *state) { return *static_cast<Faces *>(state); }

    static void *prepare(const shape *m) {
        auto *s = new Faces;
        const auto vertex = [](uint32_t v) { return Mesh::Vertex_index(v); };
        for (uint32_t v = 0; v < m->nv; v++) s->mesh.add_vertex({m->G[v].x, m->G[v].y, m->G[v].z});
        for (uint32_t c = 0; c < 3 * m->nt; c += 3) {
            const auto face = s->mesh.add_face(vertex(m->V[c]), vertex(m->V[c + 1]), vertex(m->V[c + 2]));
            if (face != Mesh::null_face()) continue;
            delete s; // not a manifold
            return nullptr;
        }
        return s;
    }

    static void *prepare_closed(const shape *m) { return m->closed ? prepare(m) : nullptr; }

    static void release(void *state) { delete &of(state); }

    static void build(void *state) {
        Faces &s = of(state);
        s.tree.reset(new Side(s.mesh));
        (*s.tree)(Epick::Point_3(0, 0, 0)); // builds on the first question
    }

    static void unbuild(void *state) { of(state).tree.reset(); }

    static void inside(void *state, const spot *at, uint32_t n, int8_t *side) {
        const Side &tree = *of(state).tree;
        for (uint32_t i = 0; i < n; i++) side[i] = int8_t(-tree({at[i].x, at[i].y, at[i].z}));
    }

    static bool cuts(void *state) {
        return CGAL::Polygon_mesh_processing::does_self_intersect<CGAL::Sequential_tag>(of(state).mesh);
    }

    static uint32_t pairs(void *state, pair *found, uint32_t room) {
        std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> all;
        const Mesh &mesh = of(state).mesh;
        CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(faces(mesh), mesh,
                                                                                std::back_inserter(all));
        uint32_t n = 0;
        for (const auto &p : all) {
            const uint32_t t = p.first, u = p.second;
            if (n < room) found[n] = {std::min(t, u), std::max(t, u)};
            n++;
        }
        return n;
    }
};

template <class K> engine over_triangles(const char *name, bool casts) {
    engine e{};
    e.name = name;
    e.share = 10;
    e.prepare = Tree<K>::prepare;
    e.release = Tree<K>::release;
    e.build = Tree<K>::build;
    e.unbuild = Tree<K>::unbuild;
    e.builds = true;
    if (casts) e.rays = Tree<K>::rays;
    e.closest = Tree<K>::closest;
    return e;
}

engine over_faces() {
    engine e{};
    e.name = "CGAL";
    e.share = 4;
    e.prepare = Faces::prepare_closed;
    e.release = Faces::release;
    e.build = Faces::build;
    e.unbuild = Faces::unbuild;
    e.inside = Faces::inside;
    return e;
}

engine self() {
    engine e{};
    e.name = "CGAL";
    e.prepare = Faces::prepare;
    e.release = Faces::release;
    e.cuts = Faces::cuts;
    e.pairs = Faces::pairs;
    return e;
}
} // namespace

const engine cgal_engines[] = {over_triangles<Epick>("CGAL-epick", true),
                               over_triangles<Plain>("CGAL-double", false),
                               over_faces(),
                               self(),
                               {}};
