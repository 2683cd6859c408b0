#!/bin/sh
# simplify.sh -- files with fewer triangles: sound if they were, of the same topology, as near or as far outside as was asked,
# and every way not to get one. NOOK names the program, build/nook by default.
. tests/tools/host.sh

member() { "$nook" check --json "$1" | grep -o "\"$2\":[^,]*" | head -1; }

# outside NAME IN OUT: no vertex of IN is outside OUT
outside() {
    sed -n 's/^v \([^ ]*\) \([^ ]*\) \([^ ]*\)$/{"point":[\1,\2,\3]}/p' "$2" >"$dir/points"
    inside=$("$nook" query "$3" <"$dir/points" 2>&1)
    case $inside in *'"side":1'* | *null* | *nook:* | '') no "$1: a vertex is outside" ;; *) ok ;; esac
}

# ---- to a count, to a distance, outside, convex --------------------------------------------------------
for shape in icosphere torus box capsule pipe gear; do
    "$nook" make $shape --triangles 1200 -o "$dir/in.obj" 2>/dev/null
    for format in stl obj off ply; do
        expect "a $shape as $format" 0 "^$dir/out.$format: \(299\|300\) triangles of [0-9]*, [0-9]* vertices of [0-9]*, no farther than [0-9.e-]*\$" \
            "$nook" simplify "$dir/in.obj" "$dir/out.$format" --triangles 300
        expect "a $shape as $format is sound" 0 '"verdict":"sound"' "$nook" check --json "$dir/out.$format"
        [ "$(member "$dir/out.$format" euler)" = "$(member "$dir/in.obj" euler)" ] && ok || no "$shape as $format: another Euler number"
    done
    expect "the same bits of a $shape again" 0 . "$nook" simplify "$dir/in.obj" "$dir/again.obj" --triangles 300
    cmp -s "$dir/out.obj" "$dir/again.obj" && ok || no "$shape: two runs differ"
    "$nook" simplify --json --error 0.01 "$dir/in.obj" "$dir/near.obj" >"$dir/said" 2>&1
    awk -F'"deviation":' '{ exit !($2 + 0 <= 0.01 && $2 + 0 >= 0) }' "$dir/said" && ok || no "$shape: $(cat "$dir/said")"
    sed -n 's/^v \([^ ]*\) \([^ ]*\) \([^ ]*\)$/{"point":[\1,\2,\3]}/p' "$dir/in.obj" |
        "$nook" query "$dir/near.obj" | awk -F'"distance":' '$2 + 0 > 0.01 { far = 1 } END { exit far || NR == 0 }' &&
        ok || no "$shape: a vertex is farther away than 0.01"
    expect "a $shape from outside" 0 ': 600 triangles' "$nook" simplify --outside --triangles 600 "$dir/in.obj" "$dir/out.obj"
    outside "a $shape" "$dir/in.obj" "$dir/out.obj"
    expect "a convex $shape" 0 'no farther than' "$nook" simplify --convex --triangles 60 "$dir/in.obj" "$dir/out.obj"
    expect "a convex $shape is convex" 0 '"convex":true' "$nook" check --json --require convex "$dir/out.obj"
    outside "a convex $shape" "$dir/in.obj" "$dir/out.obj"
done
"$nook" make sheet -o "$dir/sheet.obj" 2>/dev/null
expect 'a mesh with borders' 0 ': [0-9]* triangles of' "$nook" simplify --error 0.001 "$dir/sheet.obj" "$dir/out.obj"
[ "$(member "$dir/out.obj" border_loops)" = "$(member "$dir/sheet.obj" border_loops)" ] && ok || no 'border loops are as many as before'

# ---- what does not cut itself ----------------------------------------------------------------------------
cut=0
for shape in pipe torus gear; do
    "$nook" make $shape --triangles 320 -o "$dir/in.off" 2>/dev/null
    for n in 60 20 10; do
        "$nook" simplify --triangles $n "$dir/in.off" "$dir/out.off" >"$dir/said" 2>&1
        expect "a $shape of $n triangles does not cut itself" 0 '"verdict":"sound"' "$nook" check --json "$dir/out.off"
        for other in build/nook build/nook16; do # the same on PC and board
            [ ! -x $other ] || { $other simplify --triangles $n "$dir/in.off" "$dir/again.off" >"$dir/said" 2>&1; cmp -s "$dir/out.off" "$dir/again.off"; } &&
                ok || no "$other makes another $shape of $n triangles"
        done
        "$nook" simplify --unguarded --triangles $n "$dir/in.off" "$dir/out.off" >"$dir/said" 2>&1
        "$nook" check "$dir/out.off" | grep -q 'DEFECTIVE: [0-9]* self-intersections$' && cut=$((cut + 1))
    done
done
[ $cut -gt 0 ] && ok || no 'unguarded some would cut themselves'
"$nook" make icosphere --defect crossing -o "$dir/crossing.off" 2>/dev/null
expect 'what cuts itself anyway' 0 ': 100 triangles of 640,' "$nook" simplify --triangles 100 "$dir/crossing.off" "$dir/out.off"

# ---- what moves the surface least goes first: a pipe of flat faces, of which 400 triangles are enough ------
"$nook" make pipe --triangles 5000 -o "$dir/in.off" 2>/dev/null
said=$("$nook" simplify --json --triangles 500 "$dir/in.off" "$dir/out.off")
awk -F'"deviation":' '{ exit !($2 + 0 < 0.001) }' <<X && ok || no "a pipe of 500 triangles: $said"
$said
X
most=5000
for e in 0.0003 0.001 0.01 0.1; do
    said=$("$nook" simplify --json --error $e "$dir/in.off" "$dir/out.off" | sed 's/.*"triangles":\([0-9]*\).*/\1/')
    [ "$said" -le $most ] && ok || no "a pipe has $said triangles within $e, $most within less"
    most=$said
done

# ---- a cube ----------------------------------------------------------------------------------------------
cube='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
printf "${cube}f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n" >"$dir/cube.obj"
expect 'nothing to do' 0 '"vertices_in":8,"triangles_in":12,"vertices":8,"triangles":12,"deviation":0,"reason":null}$' \
    "$nook" simplify --json --triangles 12 "$dir/cube.obj" "$dir/out.obj"
expect 'no deviation' 0 '"vertices":8,"triangles":12,"deviation":0,"reason":null}$' "$nook" simplify --json --error 0 "$dir/cube.obj" "$dir/out.obj"
expect 'fewer than there can be' 1 'fewer than 4 triangles cannot be' "$nook" simplify --triangles 2 "$dir/cube.obj" "$dir/out.obj"
expect 'what could is written' 0 '"triangles":4,' "$nook" check --json "$dir/out.obj"
expect 'and its reason in numbers' 1 '"triangles":4,.*"reason":"[a-z_]*"}$' "$nook" simplify --json --triangles 2 "$dir/cube.obj" "$dir/out.obj"
expect '--scale' 0 '"triangles":12,' "$nook" simplify --json --scale 3 --triangles 12 "$dir/cube.obj" "$dir/out.obj"
expect 'standard output' 0 '"verdict":"sound"' sh -c "'$nook' simplify --format stl --triangles 8 '$dir/cube.obj' - 2>'$dir/said' | '$nook' check --json -"
grep -q '^-: 8 triangles of 12' "$dir/said" && ok || no "what is said moves to stderr: $(cat "$dir/said")"

# ---- no ----------------------------------------------------------------------------------------------------
rm -f "$dir/none.obj"
"$nook" make moebius -o "$dir/moebius.obj" 2>/dev/null
expect 'a Moebius strip' 1 'not a manifold, oriented mesh' "$nook" simplify --triangles 8 "$dir/moebius.obj" "$dir/none.obj"
expect 'in numbers' 1 '"triangles":null,"deviation":null,"reason":null}' "$nook" simplify --json --triangles 8 "$dir/moebius.obj" "$dir/none.obj"
expect 'a sheet has no outside' 1 'no inside to be kept' "$nook" simplify --outside --triangles 8 "$dir/sheet.obj" "$dir/none.obj"
small='v 4 0 0\nv 3 0 0\nv 3 1 0\nv 4 1 0\nv 4 0 .9\nv 3 0 .9\nv 3 1 .9\nv 4 1 .9\n'
printf "${cube}${small}f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n" >"$dir/pair.obj"
expect 'nor have two cubes of which one is inside out' 1 'no inside to be kept' "$nook" simplify --outside --triangles 16 "$dir/pair.obj" "$dir/none.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 3 2 4\n' >"$dir/flat.obj"
expect 'a flat one has no hull' 1 'no hull has a volume' "$nook" simplify --convex --triangles 8 "$dir/flat.obj" "$dir/none.obj"
printf 'OFF\n0 0 0\n' >"$dir/empty.off"
expect 'an empty one' 1 'not a manifold' "$nook" simplify --triangles 8 "$dir/empty.off" "$dir/none.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 5 4 6\n' >"$dir/loose.obj"
expect 'equal vertices that are not joined' 0 "^nook: $dir/loose.obj: hint: 2 vertices repeat .* --weld exact" "$nook" simplify --triangles 2 "$dir/loose.obj" "$dir/out.obj"
expect 'joined there is no hint' 0 "^$dir/out.obj: 2 triangles of 2" "$nook" simplify --weld exact --triangles 2 "$dir/loose.obj" "$dir/out.obj"
expect 'a mesh that is not there, in numbers' 2 '^{"file":.*"verdict":"unreadable",.*"error":{"code":"cannot_read",' "$nook" simplify --json --triangles 2 "$dir/absent.obj" "$dir/none.obj"
[ -e "$dir/none.obj" ] && no 'a file was written' || ok

# ---- wrong use ---------------------------------------------------------------------------------------------
expect 'neither count nor distance' 2 'needs --triangles N or --error E' "$nook" simplify "$dir/cube.obj" "$dir/out.obj"
expect 'both' 2 'needs --triangles N or --error E' "$nook" simplify --triangles 4 --error 1 "$dir/cube.obj" "$dir/out.obj"
expect 'outside and convex' 2 'give one of them' "$nook" simplify --triangles 4 --outside --convex "$dir/cube.obj" "$dir/out.obj"
expect 'OUT that is IN' 2 'another file than IN' "$nook" simplify --triangles 4 "$dir/cube.obj" "$dir/./cube.obj"
expect 'no triangles' 2 'above 0' "$nook" simplify --triangles 0 "$dir/cube.obj" "$dir/out.obj"
expect 'a count that is none' 2 'needs a count' "$nook" simplify --triangles few "$dir/cube.obj" "$dir/out.obj"
expect 'a distance below 0' 2 'needs a length' "$nook" simplify --error -1 "$dir/cube.obj" "$dir/out.obj"
expect 'no OUT' 2 'simplify needs IN and OUT' "$nook" simplify --triangles 4 "$dir/cube.obj"
expect 'no format' 2 'no format' "$nook" simplify --triangles 4 "$dir/cube.obj" "$dir/out"
expect 'a mesh that is not there' 2 "^nook: $dir/absent.obj: " "$nook" simplify --triangles 4 "$dir/absent.obj" "$dir/out.obj"
expect 'a folder that is not there' 2 "^nook: $dir/absent/out.obj: " "$nook" simplify --triangles 4 "$dir/cube.obj" "$dir/absent/out.obj"
expect 'an option of others' 2 'has no option --budget' "$nook" simplify --budget 3 --triangles 4 "$dir/cube.obj" "$dir/out.obj"
expect 'help' 0 'the same shape with fewer triangles' "$nook" simplify --help
expect 'help asked for otherwise' 0 'the same shape with fewer triangles' "$nook" help simplify
expect 'help about all' 0 'nook simplify IN OUT' "$nook" help
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
