#!/bin/sh
# readme_example.sh -- the firmware example of README.md must compile without a warning and run; its commands must print what it says.
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
awk '/^```c$/ {on = 1; next} /^```$/ {on = 0} on' README.md >"$dir/example.c"
cat >"$dir/main.c" <<'C'
#include <stdio.h>
#include <stddef.h>
#include <stdint.h>
size_t uart_read(uint8_t *bytes, size_t room);
int example(void);
static FILE *file;
size_t uart_read(uint8_t *bytes, size_t room) { return fread(bytes, 1, room, file); }
int main(int argc, char **argv) { return argc == 2 && (file = fopen(argv[1], "rb")) != NULL ? example() : 2; }
C
passed=0 failed=0
expect() { # file, exit status
    "$dir/example" "$1"
    if [ $? = "$2" ]; then passed=$((passed + 1)); else echo "the example said $? of $1"; failed=$((failed + 1)); fi
}
if ${CC:-cc} -std=c99 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Isrc "$dir/example.c" "$dir/main.c" src/*/*.c -o "$dir/example"; then
    build/nook make icosphere --triangles 80 -o "$dir/good.stl" && expect "$dir/good.stl" 0
    build/nook make icosphere --triangles 80 --defect hole -o "$dir/bad.stl" && expect "$dir/bad.stl" 1
else
    failed=1
fi
build/nook make icosphere --triangles 320 -o build/sound.stl && build/nook make icosphere --triangles 320 --defect hole -o build/hole.stl
awk '/^```/ {on = !inside && $0 == "```"; inside = !inside; next} on' README.md >"$dir/told"
grep '^build/nook' "$dir/told" | while read -r command; do
    echo "$command"
    $command 2>/dev/null
done >"$dir/said"
if diff "$dir/told" "$dir/said"; then passed=$((passed + 1)); else echo "README.md tells (<) what is not so (>)" && failed=$((failed + 1)); fi
echo "$passed passed, $failed failed, 0 skipped"
[ $failed -eq 0 ] && [ $passed -eq 3 ]
