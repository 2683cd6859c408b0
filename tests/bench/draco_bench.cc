// draco_bench.cc -- Draco's CornerTable on the triangles of an OBJ, for callgrind and for the clock.
// usage: draco_bench FILE TIMES. Built on request against Debian's libdraco-dev; see link_bench.c.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include <draco/mesh/corner_table.h>

using Faces = draco::IndexTypeVector<draco::FaceIndex, draco::CornerTable::FaceType>;

__attribute__((noinline)) std::unique_ptr<draco::CornerTable> link_faces(const Faces &faces)
{
    return draco::CornerTable::Create(faces);
}

int main(int argc, char **argv)
{
    if (argc < 3) return 2;
    Faces faces;
    std::ifstream in(argv[1]);
    for (std::string line; std::getline(in, line);) {
        unsigned a, b, c;
        if (std::sscanf(line.c_str(), "f %u %u %u", &a, &b, &c) != 3) continue;
        faces.push_back({{draco::VertexIndex(a - 1), draco::VertexIndex(b - 1), draco::VertexIndex(c - 1)}});
    }
    double best = 1e30;
    unsigned corners = 0;
    for (int i = 0; i < std::atoi(argv[2]); i++) {
        const auto begin = std::chrono::steady_clock::now();
        const auto table = link_faces(faces);
        const auto end = std::chrono::steady_clock::now();
        corners = table ? table->num_corners() : 0;
        best = std::min(best, std::chrono::duration<double, std::nano>(end - begin).count());
    }
    std::printf("Draco: %u corners, %.1f ns a triangle\n", corners, best / double(faces.size()));
    return 0;
}
