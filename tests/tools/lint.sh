#!/bin/sh
# lint.sh -- every warning is an error; gcc and clang, both widths, C++; then clang-tidy and cppcheck.
# usage: lint.sh FLAGS...   A tool that is not here is skipped, loudly, or fails where REQUIRE is 1.
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
sources=$(ls src/*/*.c tests/*.c host_sim/*.c port/posix/*.c port/template/*.c)
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
for cc in "$CC" clang; do
    missing "$cc" && continue
    for bits in 16 32; do
        status=0
        for file in $sources; do
            $cc $flags -Werror -DNOOK_INDEX_BITS=$bits -c "$file" -o "$dir/o" || status=1
        done
        say "$cc, $bits bits" $status
    done
done
for cxx in g++ clang++; do
    missing $cxx && continue
    printf '#include "nook.h"\nint main() { nook_mesh m; return nook_mesh_init(&m, 0, 0, 0, 0, 0, 0) + (int)nook_status_name(NOOK_OK)[0] * 0; }\n' >"$dir/use.cc"
    $cxx -std=c++11 -Wall -Wextra -Werror -Isrc -c "$dir/use.cc" -o "$dir/o" && $CC $flags -c src/core/nook_mesh.c -o "$dir/m" &&
        $CC $flags -c src/core/nook_status.c -o "$dir/s" && $cxx "$dir/o" "$dir/m" "$dir/s" -o "$dir/use"
    say "$cxx, nook.h as C++" $?
done
if ! missing clang-tidy; then
    clang-tidy --quiet $(ls src/*/*.c) -- $flags 2>/dev/null
    say clang-tidy $?
fi
if ! missing cppcheck; then
    cppcheck --quiet --error-exitcode=1 --enable=warning,portability,performance --inline-suppr --std=c99 -UNOOK_USER_CONFIG -Isrc -Iport -Ihost_sim -Itests \
        --suppress=missingIncludeSystem src host_sim port tests
    say cppcheck $?
fi
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
