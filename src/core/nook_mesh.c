/* nook_mesh.c -- meshes and views over the caller's arrays: sizes, checked beginnings, one append. */
#include "core/nook_mesh.h"

#include "core/nook_vector.h"

size_t nook_mesh_bytes(uint32_t max_nv, uint32_t max_nt) {
    uint64_t bytes = (uint64_t)max_nv * (sizeof(nook_point) + sizeof(nook_index)) +
                     (uint64_t)max_nt * 6u * sizeof(nook_index);
    if (max_nv > NOOK_MAX_VERTICES || max_nt > NOOK_MAX_TRIANGLES) return 0;
    return (size_t)bytes == bytes ? (size_t)bytes : 0;
}

static bool aligned(const void *array, size_t element) { return (uintptr_t)array % element == 0; }

static nook_status tables_status(const nook_point *G, const nook_index *V, const nook_index *O,
                                 const nook_index *C, uint32_t nv, uint32_t nt) {
    if (nv > 0 && (G == NULL || C == NULL)) return NOOK_NULL_ARGUMENT;
    if (nt > 0 && (V == NULL || O == NULL)) return NOOK_NULL_ARGUMENT;
    if (nv > NOOK_MAX_VERTICES || nt > NOOK_MAX_TRIANGLES) return NOOK_NO_CAPACITY;
    if (!aligned(G, NOOK_ALIGNMENT) || !aligned(C, sizeof *C)) return NOOK_MISALIGNED;
    if (!aligned(V, sizeof *V) || !aligned(O, sizeof *O)) return NOOK_MISALIGNED;
    return NOOK_OK;
}

nook_status nook_mesh_init(nook_mesh *mesh, nook_point *G, nook_index *V, nook_index *O, nook_index *C,
                           uint32_t max_nv, uint32_t max_nt) {
    const nook_mesh made = {G, V, O, C, 0, 0, max_nv, max_nt};
    nook_status status = tables_status(G, V, O, C, max_nv, max_nt);
    if (mesh == NULL) return NOOK_NULL_ARGUMENT;
    memset(mesh, 0, sizeof *mesh);
    if (status == NOOK_OK) *mesh = made;
    return status;
}

nook_status nook_view_init(nook_view *view, const nook_point *G, const nook_index *V, const nook_index *O,
                           const nook_index *C, uint32_t nv, uint32_t nt) {
    const nook_view made = {G, V, O, C, nv, nt};
    nook_status status = tables_status(G, V, O, C, nv, nt);
    if (view == NULL) return NOOK_NULL_ARGUMENT;
    memset(view, 0, sizeof *view);
    if (status == NOOK_OK) *view = made;
    return status;
}

nook_status nook_mesh_append(nook_mesh *mesh, const nook_point corners[3]) {
    uint32_t i;
    NOOK_REQUIRE(mesh != NULL && corners != NULL);
    if (mesh->nt >= mesh->max_nt || mesh->max_nv - mesh->nv < 3u) return NOOK_NO_CAPACITY;
    for (i = 0; i < 3u; i++) {
        mesh->G[mesh->nv + i] = corners[i];
        mesh->V[3u * mesh->nt + i] = nook_store(mesh->nv + i);
    }
    mesh->nv += 3u;
    mesh->nt++;
    return NOOK_OK;
}

static nook_status coordinate_status(float x) {
    if ((nook_float_bits(x) & 0x7F800000u) == 0x7F800000u) return NOOK_NOT_FINITE;
    if (x > NOOK_MAX_COORDINATE || x < -NOOK_MAX_COORDINATE) return NOOK_COORDINATE_TOO_LARGE;
    return NOOK_OK;
}

nook_status nook_point_status(nook_point point) {
    nook_status status = coordinate_status(point.x);
    if (status == NOOK_OK) status = coordinate_status(point.y);
    if (status == NOOK_OK) status = coordinate_status(point.z);
    return status;
}
