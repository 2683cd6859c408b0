#!/bin/sh
# outward.sh -- which way shells face, as check says it: solids, cavities, solids in cavities, shells that touch or cross.
# NOOK names the program, build/nook by default.
. tests/tools/host.sh

# boxes "LOW HIGH WAY"... : cubes from LOW to HIGH on each axis, WAY out or in
boxes() {
    for box in "$@"; do echo "$box"; done | awk '{
        for (i = 0; i < 8; i++) print "v", (i % 2 ? $2 : $1), (int(i / 2) % 2 ? $2 : $1), (i > 3 ? $2 : $1)
        n = split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", v)
        for (i = 1; i <= n; i += 3) {
            j = i + ($3 == "in" ? 2 : 1); k = i + ($3 == "in" ? 1 : 2)
            print "f", v[i] + 8 * NR - 7, v[j] + 8 * NR - 7, v[k] + 8 * NR - 7
        }
    }' >"$dir/boxes.obj"
}

# expect NAME STATUS PATTERN [OPTION...] : of check on the boxes
expect() {
    name=$1 status=$2 pattern=$3
    shift 3
    said=$("$nook" check "$@" "$dir/boxes.obj" 2>&1)
    got=$?
    if [ $got -eq "$status" ] && printf '%s\n' "$said" | grep -q -e "$pattern"; then passed=$((passed + 1))
    else failed=$((failed + 1)); echo "FAILED: $name: exit $got instead of $status, or no '$pattern' in: $said"; fi
}

boxes '0 9 out'
expect 'a solid is outward' 0 '^  outward    yes$'
boxes '0 9 in'
expect 'one that is inside out is not' 1 '"outward":false.*"inside_out":true.*"code":"inside_out","severity":"error","count":1' --json
boxes '0 9 out' '1 8 in'
expect 'a cavity faces into itself' 0 '"verdict":"sound".*"outward":true,"inside_out":false' --json
expect 'and is counted' 0 '^  outward    yes; 1 of 2 shells bounds a cavity$'
boxes '0 9 out' '1 8 out'
expect 'a cavity that faces out of itself does not' 1 '"outward":false.*"code":"inside_out".*"count":1,"elements":\[{"triangle":12,' --json
expect 'and is told' 1 '^  outward    no; 1 of 2 shells bounds a cavity$'
boxes '3 6 in' '0 9 out' '2 7 out' '4 5 out' '1 8 in'
expect 'boxes in boxes' 0 '^  outward    yes; 2 of 5 shells bound cavities$'
boxes '3 6 in' '0 9 in' '2 7 out' '4 5 in' '1 8 in'
expect 'two of them the wrong way' 1 '"outward":false.*"code":"inside_out".*"count":2,.*"triangle":12,.*"triangle":36,' --json
boxes '0 2 out' '2 3 out'
expect 'shells that touch with corners are told and outward' 1 '"outward":true.*"self_intersections":[1-9]' --json
expect 'and sound once that corner is one' 0 'outward' --weld exact --require outward,watertight,oriented,no-self-intersection
boxes '0 9 out' '1 20 in'
expect 'where shells cross, outward is undefined' 1 '"outward":null' --json
expect 'and the text says why' 1 '^  outward    undefined: shells cross'

echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
