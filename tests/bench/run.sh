#!/bin/sh
# run.sh -- nook_link and Draco's CornerTable on the same three meshes, one after the other in turn:
# nanoseconds a triangle, best of 20; with valgrind also instructions. Built here, on request only.
set -e
dir=build/bench
mkdir -p $dir
cc -O2 -g -std=c99 -ffp-contract=off -fno-math-errno -Isrc tests/bench/link_bench.c src/*/*.c -o $dir/link16
cc -O2 -g -std=c99 -ffp-contract=off -fno-math-errno -DNOOK_INDEX_BITS=32 -Isrc tests/bench/link_bench.c src/*/*.c -o $dir/link32
c++ -O2 -g tests/bench/draco_bench.cc -ldraco -o $dir/draco
count() { # function, command: instructions a triangle
    command -v valgrind >/dev/null || return 0
    function=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$function" "$@" 2>&1 >/dev/null |
        awk '/Collected/ {printf "    %.0f instructions a triangle\n", $NF / 20480}'
}
for mesh in ordered shuffled hub; do
    $dir/link16 $mesh write >$dir/$mesh.obj
    for bits in 16 32; do
        echo "nook, $bits-bit indices, $($dir/link$bits $mesh 20)"
        count nook_link $dir/link$bits $mesh 1
    done
    $dir/draco $dir/$mesh.obj "$([ $mesh = hub ] && echo 3 || echo 20)"
    count 'link_faces*' $dir/draco $dir/$mesh.obj 1
done
