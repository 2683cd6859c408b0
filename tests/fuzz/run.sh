#!/bin/sh
# run.sh -- build the fuzz targets and run each for a third of the time, from seeds that are made here.
# usage: run.sh SECONDS   (15 and more; repeatable but for how far the time reaches: fixed seed, fresh corpus)
# The last line is "N passed, N failed, N skipped"; a target that failed leaves its input in build/fuzz.
# Needs clang with its fuzzer runtime, and build/nook for seeds of real files.
seconds=${1:?usage: run.sh SECONDS}
cd "$(dirname "$0")/../.." || exit 1
CC=${FUZZ_CC:-clang} out=build/fuzz passed=0 failed=0
mkdir -p $out
FLAGS="-std=c99 -O1 -g -ffp-contract=off -fno-math-errno -fno-omit-frame-pointer -fno-sanitize-recover=all
    -Isrc -Iport -Ihost_sim -Itests -Itests/prove -Itests/fuzz"
echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { return d == 0 && n != 0; }' >$out/probe.c
if ! $CC -fsanitize=fuzzer,address,undefined $out/probe.c -o $out/probe 2>/dev/null; then
    echo "SKIPPED: $CC or its fuzzer runtime is not installed"
    echo "0 passed, 0 failed, 3 skipped"
    exit 0
fi

# ---- seeds ------------------------------------------------------------------------------------------
rm -rf $out/corpus_*
mkdir -p $out/corpus_stl $out/corpus_mesh $out/corpus_file
if [ -x build/nook ]; then
    for shape in tetrahedron box sheet moebius; do
        for ending in stl obj off ply; do
            build/nook make $shape --triangles 12 -o $out/corpus_file/$shape.$ending 2>/dev/null
        done
        { cat $out/corpus_file/$shape.stl; printf '\001\007\062\000\377\020\003\060\001'; } >$out/corpus_stl/$shape
    done
    for defect in nan unwelded isolated degenerate; do
        build/nook make tetrahedron --defect $defect -o $out/corpus_file/$defect.ply 2>/dev/null
    done
fi
facet='facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1e0 0.5 -2\nvertex +3. .25 1E-3\nendloop\n'
facet="${facet}endfacet\n"
# shellcheck disable=SC2059 # the facet is a format
printf "solid a b\n${facet}${facet}endsolid a b\n" >$out/corpus_file/text.stl
{ cat $out/corpus_file/text.stl; printf '\001\002\003\004\005\006\007\010\000'; } >$out/corpus_stl/text
printf '%s\n' 'v 0 0 0' 'v 1 0 0 # c' 'v 0 1 0' 'v 0 0 1' 'f 1/1/1 3//2 2' 'f 1 2 4' 'f -3 -2 -1' 'f 1 4 3 \' 2 \
    >$out/corpus_file/text.obj
printf '%s\n' ply 'format ascii 1.0' 'element vertex 3' 'property float x' 'property float y' 'property float z' \
    'element face 1' 'property list uchar int vertex_indices' end_header '0 0 0' '1 0 0' '0 1 0' '3 0 1 2' \
    >$out/corpus_file/text.ply

# Of fuzz_mesh: vertices - 1, triangles, options, shells; V; G in a grid; nothing spoiled; slices.
mesh() { # name, vertices - 1 and triangles and the rest, as printf has it
    # shellcheck disable=SC2059
    for options in 000 360 364; do printf "$2\\$options\\000$3" >$out/corpus_mesh/$1_$options; done
}
mesh tetrahedron '\003\004' '\0\2\1\0\1\3\1\2\3\2\0\3\0\1\4\20\2\1\7\14\2\1\3'
mesh moebius '\004\005' '\0\1\2\1\2\3\2\3\4\3\4\0\4\0\1\0\1\4\20\5'
mesh bow_tie '\006\010' '\0\2\1\0\1\3\1\2\3\2\0\3\3\5\4\3\4\6\4\5\6\5\3\6\0\1\4\20\2\6\22'
mesh book '\005\004' '\0\1\2\0\1\3\1\0\4\0\1\5\0\1\2\3\4\5'
mesh twins '\002\003' '\0\1\2\0\1\2\0\2\1\0\1\4'
mesh isolated '\007\002' '\0\1\2\2\1\3\0\1\4\20\2\2\2\2'
hub='' i=1
while [ $i -lt 39 ]; do hub="$hub\\0\\$(printf %o $i)\\$(printf %o $((i + 1)))" i=$((i + 1)); done
mesh hub '\047\046' "$hub"

# ---- runs --------------------------------------------------------------------------------------------
say_failed() { failed=$((failed + 1)); echo "FAILED: $1"; }

fuzz() { # name, longest input, index bits, sources and flags
    name=$1 longest=$2 bits=$3
    shift 3
    # shellcheck disable=SC2086
    if ! $CC $FLAGS -DNOOK_INDEX_BITS=$bits -fsanitize=fuzzer,address,undefined src/*/*.c \
        tests/fuzz/fuzz_$name.c "$@" -o $out/fuzz_$name; then
        say_failed "fuzz_$name does not compile"
        return
    fi
    if $out/fuzz_$name -seed=1 -max_total_time=$((seconds / 3)) -max_len=$longest -timeout=10 -rss_limit_mb=2048 \
        -malloc_limit_mb=512 -artifact_prefix=$out/${name}_ -dict=tests/fuzz/mesh.dict \
        -print_final_stats=1 $out/corpus_$name >$out/$name.log 2>&1; then
        passed=$((passed + 1))
        echo "fuzz_$name: $(sed -n 's/^stat::number_of_executed_units: *//p' $out/$name.log) inputs," \
            "$(ls $out/corpus_$name | wc -l) kept, $(sed -n 's/.*DONE *\(cov: [0-9]*\).*/\1/p' $out/$name.log)," \
            "at most $(sed -n 's/^stat::peak_rss_mb: *//p' $out/$name.log) MB"
    else
        grep -v '^#[0-9]*.*\(NEW\|REDUCE\|pulse\|RELOAD\)' $out/$name.log | tail -n 60
        say_failed "fuzz_$name; try: $out/fuzz_$name $out/${name}_..."
    fi
}
helpers='' # of fuzz_mesh: not instrumented, since only the library's paths are to be found; much faster
for helper in tests/oracle.c tests/shapes.c tests/check.c port/posix/nook_port.c; do
    object=$out/$(basename $helper .c).o
    helpers="$helpers $object"
    # shellcheck disable=SC2086
    $CC $FLAGS -O2 -DNOOK_INDEX_BITS=16 -c $helper -o $object || failed=$((failed + 1))
done
fuzz stl 2048 32
# Its input is no text: guided by paths, not by words.
# shellcheck disable=SC2086
fuzz mesh 512 16 $helpers -fno-sanitize-coverage=trace-cmp
fuzz file 4096 32 host_sim/import*.c host_sim/bytes.c host_sim/heap.c host_sim/failure.c host_sim/scan.c
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ]
