// orient_cgal.cc -- random solids oriented by nook and by CGAL, triangle by triangle.
//
// A solid is up to 24 boxes, spheres and tori of random places, sizes and turns; most are put where they cross no other, which
// nests them as it happens, and in one solid of four the last ones may cross others. Triangles run either way. CGAL: orient_polygon_soup,
// does_self_intersect, orient_to_bound_a_volume, and the nesting levels of volume_connected_components. nook: nook_orient,
// nook_link, nook_check, nook_bvh_build, nook_orient_shells. They must agree on which solids cross themselves, on every triangle's
// direction of the others, and on which shells are cavities.
//
// usage: orient_cgal [solids [seed]]
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "nook.h"

namespace {
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangle = std::array<std::size_t, 3>;

std::mt19937 dice;

double part() { return dice() * (1.0 / 4294967296.0); }
double between(double low, double high) { return low + (high - low) * part(); }

struct Solid {
    std::vector<nook_point> points;
    std::vector<Triangle> triangles;
};

// ---- shells ---------------------------------------------------------------------------------------------
Solid box() {
    static const int list[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    Solid s;
    for (int v = 0; v < 8; v++)
        s.points.push_back({v & 1 ? 1.0f : -1.0f, v & 2 ? 0.8f : -0.8f, v & 4 ? 0.6f : -0.6f});
    for (const auto &t : list)
        s.triangles.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
    return s;
}

// Cells of columns x rows; a torus, or with poles a sphere.
Solid round(int columns, int rows, bool torus) {
    Solid s;
    const auto at = [&](int i, int j) { return std::size_t(i % columns * rows + j % rows); };
    const double turn = 2 * M_PI;
    for (int i = 0; i < columns; i++) {
        for (int j = 0; j < rows; j++) {
            const double a = turn * i / columns, b = torus ? turn * j / rows : turn / 2 * (j + 0.5) / rows;
            const double r = torus ? 1 + 0.3 * std::cos(b) : std::sin(b),
                         z = torus ? 0.3 * std::sin(b) : -std::cos(b);
            s.points.push_back({float(r * std::cos(a)), float(r * std::sin(a)), float(z)});
        }
    }
    for (int i = 0; i < columns; i++) {
        for (int j = 0; j < rows - !torus; j++) {
            s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
        if (torus) continue;
        s.triangles.push_back({at(i + 1, 0), at(i, 0), std::size_t(columns * rows)});
        s.triangles.push_back({at(i, rows - 1), at(i + 1, rows - 1), std::size_t(columns * rows + 1)});
    }
    if (!torus) {
        s.points.push_back({0, 0, -1});
        s.points.push_back({0, 0, 1});
    }
    return s;
}

// Turned about two axes, scaled and moved.
void put(Solid &s) {
    const double a = between(0, 6.28), b = between(0, 6.28), size = std::pow(2.0, between(-3, 3));
    const double x = between(-9, 9) * part(), y = between(-9, 9) * part(), z = between(-9, 9) * part();
    for (nook_point &p : s.points) {
        const double u = p.x * std::cos(a) - p.y * std::sin(a), v = p.x * std::sin(a) + p.y * std::cos(a);
        const double w = v * std::cos(b) - p.z * std::sin(b), t = v * std::sin(b) + p.z * std::cos(b);
        p = {float(x + size * u), float(y + size * w), float(z + size * t)};
    }
}

Solid shell() {
    Solid s = dice() % 3 == 0 ? box() : dice() % 2 ? round(7, 5, true) : round(6, 4, false);
    put(s);
    return s;
}

std::vector<Point> exact(const std::vector<nook_point> &points) {
    std::vector<Point> to;
    for (const nook_point &p : points) to.emplace_back(p.x, p.y, p.z);
    return to;
}

Mesh mesh_of(const Solid &s) {
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(exact(s.points), s.triangles, mesh);
    return mesh;
}

Solid throw_solid() {
    std::vector<Solid> shells;
    std::vector<Mesh> meshes;
    const bool careless = dice() % 4 == 0;
    const std::size_t wanted = 1 + dice() % 24;
    for (int tries = 0; tries < 200 && shells.size() < wanted; tries++) {
        Solid s = shell();
        Mesh mesh = mesh_of(s);
        bool crosses = false;
        for (const Mesh &other : meshes) crosses = crosses || PMP::do_intersect(mesh, other);
        if (crosses && (!careless || 2 * shells.size() < wanted)) continue;
        shells.push_back(s);
        meshes.push_back(mesh);
    }
    Solid all;
    for (const Solid &s : shells) {
        const std::size_t first = all.points.size();
        all.points.insert(all.points.end(), s.points.begin(), s.points.end());
        for (const Triangle &t : s.triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    std::shuffle(all.triangles.begin(), all.triangles.end(), dice);
    for (Triangle &t : all.triangles)
        if (dice() % 2) std::swap(t[1], t[2]);
    return all;
}

// ---- the two ---------------------------------------------------------------------------------------------
struct Answer {
    bool crosses = false;
    std::vector<Triangle> triangles;
    std::vector<bool> cavity; // of the shell of each triangle
};

Answer ask_cgal(const Solid &s) {
    Answer a;
    std::vector<Point> points = exact(s.points);
    std::vector<Triangle> triangles = s.triangles;
    if (!PMP::orient_polygon_soup(points, triangles)) std::abort();
    Mesh mesh;
    PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    a.crosses = PMP::does_self_intersect(mesh);
    if (a.crosses) return a;
    PMP::orient_to_bound_a_volume(mesh);
    auto volume = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:volume", 0).first;
    auto surface = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface", 0).first;
    std::vector<std::size_t> levels;
    PMP::volume_connected_components(
        mesh, volume,
        CGAL::parameters::nesting_levels(std::ref(levels)).face_connected_component_map(surface));
    for (const auto f : mesh.faces()) {
        Triangle t{};
        std::size_t i = 0;
        for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) t[i++] = v;
        a.triangles.push_back(t);
        a.cavity.push_back(levels[surface[f]] % 2 != 0);
    }
    return a;
}

void require(bool good, const char *what) {
    if (good) return;
    std::fprintf(stderr, "orient_cgal: %s\n", what);
    std::abort();
}

Answer ask_nook(const Solid &s) {
    const uint32_t nv = uint32_t(s.points.size()), nt = uint32_t(s.triangles.size());
    std::vector<nook_point> G = s.points;
    std::vector<nook_index> V, O(3 * nt), C(nv), component(nt), stamp(nv), order(nt);
    std::vector<uint8_t> Mt(NOOK_MT_BYTES(nt)), Mv(NOOK_MV_BYTES(nv));
    std::vector<nook_shell> shell(nt);
    std::vector<nook_boxes> boxes(NOOK_BVH_GROUPS(nt));
    for (const Triangle &t : s.triangles)
        for (const std::size_t v : t) V.push_back(nook_index(v));
    nook_mesh mesh;
    nook_marks marks = {Mt.data(), Mv.data(), nt, nv};
    nook_shells shells = {shell.data(), component.data(), stamp.data(), nt, 0};
    nook_report report;
    nook_check_result result;
    nook_bvh bvh;
    require(nook_mesh_init(&mesh, G.data(), V.data(), O.data(), C.data(), nv, nt) == NOOK_OK, "no mesh");
    mesh.nv = nv;
    mesh.nt = nt;
    require(nook_orient(&mesh, &marks, nullptr, nullptr, nullptr) == NOOK_OK, "not orientable");
    require(nook_link(&mesh, &marks, &shells, nullptr, &report, nullptr) == NOOK_OK, "not linked");
    const nook_view view = nook_view_of(&mesh);
    require(nook_check(&view, &marks, &report, &shells, nullptr, &result) == NOOK_OK, "not checked");
    require(nook_bvh_build(&bvh, &view, boxes.data(), order.data(), nullptr) == NOOK_OK, "no tree");
    Answer a;
    nook_orient_shells_state state;
    const nook_status status = nook_orient_shells(&state, &mesh, &bvh, &shells, nullptr, nullptr);
    a.crosses = status == NOOK_SELF_INTERSECTION;
    require(a.crosses || status == NOOK_OK, "not oriented");
    for (uint32_t t = 0; t < nt && !a.crosses; t++) {
        a.triangles.push_back({V[3 * t], V[3 * t + 1], V[3 * t + 2]});
        a.cavity.push_back(shell[component[t]].cavity == NOOK_YES);
    }
    return a;
}

bool same_direction(const Triangle &t, const Triangle &u) {
    for (std::size_t i = 0; i < 3; i++)
        if (t[0] == u[i]) return t[1] == u[(i + 1) % 3] && t[2] == u[(i + 2) % 3];
    return false;
}

bool agree(const Answer &a, const Answer &b) {
    if (a.crosses != b.crosses || a.triangles.size() != b.triangles.size() || a.cavity != b.cavity)
        return false;
    for (std::size_t t = 0; t < a.triangles.size(); t++)
        if (!same_direction(a.triangles[t], b.triangles[t])) return false;
    return true;
}
} // namespace

int main(int argc, char **argv) {
    const int solids = argc > 1 ? std::atoi(argv[1]) : 1000;
    int passed = 0, failed = 0, crossing = 0;
    std::size_t triangles = 0, in_cavities = 0;
    dice.seed(argc > 2 ? std::atoi(argv[2]) : 1);
    for (int i = 0; i < solids; i++) {
        const Solid s = throw_solid();
        const Answer by_nook = ask_nook(s);
        (agree(by_nook, ask_cgal(s)) ? passed : failed)++;
        crossing += by_nook.crosses;
        triangles += s.triangles.size();
        for (const bool cavity : by_nook.cavity) in_cavities += cavity;
    }
    std::printf("%d solids, %zu triangles, %zu of them of cavities; %d cross themselves\n", solids, triangles,
                in_cavities, crossing);
    std::printf("%d passed, %d failed, 0 skipped\n", passed, failed);
    return failed != 0;
}
