#!/bin/sh
# width_guard.sh -- an application built for one index width must not link with a library of the other.
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
cat >"$dir/app.c" <<'C'
#include "nook.h"
int main(void)
{
    nook_mesh mesh;
    return (int)nook_mesh_init(&mesh, NULL, NULL, NULL, NULL, 0, 0);
}
C
passed=0 failed=0
for app in 16 32; do
    for library in 16 32; do
        if ${CC:-cc} -std=c99 -Isrc -DNOOK_INDEX_BITS=$app -c "$dir/app.c" -o "$dir/app.o" &&
            ${CC:-cc} -std=c99 -Isrc -DNOOK_INDEX_BITS=$library -c src/core/nook_mesh.c -o "$dir/mesh.o" &&
            ${CC:-cc} "$dir/app.o" "$dir/mesh.o" -o "$dir/app" 2>"$dir/said"; then linked=1; else linked=0; fi
        expected=0
        [ $app != $library ] || expected=1
        if [ $linked = $expected ] && { [ $linked = 1 ] || grep -q "for_${app}_bit_indices" "$dir/said"; }; then
            passed=$((passed + 1))
        else
            echo "application $app, library $library: linked $linked, expected $expected"
            failed=$((failed + 1))
        fi
    done
done
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]
