#!/bin/sh
# lint.sh -- every warning is an error; gcc and clang, both widths, C++; then clang-tidy and cppcheck.
# usage: lint.sh FLAGS...   A tool that is not here is skipped, loudly, or fails where REQUIRE is 1.
CC=${CC:-cc} REQUIRE=${REQUIRE:-0}
passed=0 failed=0 skipped=0
say() { # name, status
    if [ "$2" = 0 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $1"; fi
}
missing() {
    command -v "$1" >/dev/null && return 1
    echo "SKIPPED: no $1"
    if [ "$REQUIRE" = 1 ]; then failed=$((failed + 1)); else skipped=$((skipped + 1)); fi
}
flags=$(for f in "$@"; do case $f in -MMD | -MP | -g) ;; *) echo "$f" ;; esac; done)
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
# Two at a time; all are tried.
compiles() { # compiler and flags; the files' names come on standard input
    xargs -P 2 -n 1 "$@" $flags -Werror -o /dev/null -c
}
for cc in "$CC" clang; do
    missing "$cc" && continue
    for bits in 16 32; do
        ls src/*/*.c tests/*.c host_sim/*.c port/posix/*.c port/template/*.c | compiles "$cc" -DNOOK_INDEX_BITS=$bits
        say "$cc, $bits bits" $?
    done
done
if ! missing arm-none-eabi-gcc; then # what only a board's compiler understands, for the least and the usual core
    for core in "-mcpu=cortex-m0" "-mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16"; do
        ls src/*/*.c port/semihosting/*.c port/template/*.c boards/*/*.c | compiles arm-none-eabi-gcc $core -mthumb
        say "arm-none-eabi-gcc $core" $?
    done
fi
# nook.h from C++: every inline function compiles, and a C++ program links with the library built as C.
cat >"$dir/use.cc" <<'CC'
#include "nook.h"
int main() { nook_mesh m; return nook_mesh_init(&m, 0, 0, 0, 0, 0, 0) == NOOK_OK || *nook_status_name(NOOK_OK) == 0; }
CC
for cxx in g++ clang++; do
    missing $cxx && continue
    for standard in 98 11 17; do
        $cxx -std=c++$standard -Wall -Wextra -Werror -Isrc -c "$dir/use.cc" -o "$dir/use.o" &&
            for unit in mesh status; do $CC $flags -c src/core/nook_$unit.c -o "$dir/$unit.o" || break; done &&
            $cxx "$dir/use.o" "$dir/mesh.o" "$dir/status.o" -o "$dir/use"
        say "$cxx, nook.h as C++$standard" $?
    done
done
if ! missing clang-tidy; then
    ls src/*/*.c | xargs -P 2 -I{} clang-tidy --quiet {} -- $flags 2>/dev/null
    say clang-tidy $?
fi
if ! missing cppcheck; then
    cppcheck -j 2 --quiet --error-exitcode=1 --enable=warning,portability,performance --inline-suppr --std=c99 -UNOOK_USER_CONFIG -Isrc -Iport -Ihost_sim -Itests \
        --suppress=missingIncludeSystem src host_sim port boards tests
    say cppcheck $?
fi
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
