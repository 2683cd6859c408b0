#!/bin/sh
# hull.sh -- convex hulls of files: sound and convex whatever went in, the same again of themselves, and every way not
# to get one. NOOK names the program, build/nook by default.
. tests/tools/host.sh

convex='convex,manifold,watertight,oriented,outward,no-degenerate,no-duplicate,no-self-intersection,no-isolated'
for shape in icosphere torus box capsule pipe gear tetrahedron moebius; do
    "$nook" make $shape -o "$dir/$shape.off" 2>/dev/null
    for format in stl obj off ply; do
        expect "the hull of a $shape as $format" 0 "^$dir/hull.$format: hull of [0-9]* vertices, [0-9]* triangles: [0-9]* vertices, [0-9]* triangles, volume [0-9.]*\$" \
            "$nook" hull "$dir/$shape.off" "$dir/hull.$format"
        expect "the hull of a $shape in $format is sound and convex" 0 '"verdict":"sound"' "$nook" check --json --require $convex "$dir/hull.$format"
    done
    expect "the hull of a $shape is its own hull" 0 'hull of \([0-9]* vertices, [0-9]* triangles\): \1, volume' "$nook" hull "$dir/hull.off" "$dir/again.off"
    sed -n '3,12s/^\([^ ]*\) \([^ ]*\) \([^ ]*\)$/{"point":[\1,\2,\3]}/p' "$dir/$shape.off" >"$dir/points"
    inside=$("$nook" query "$dir/hull.off" <"$dir/points" 2>&1)
    case $inside in *'"side":1'* | *null* | *nook:* | '') no "points of a $shape outside its hull: $inside" ;; *) ok ;; esac
done

# ---- a cube and points in it, on it, and beside it ---------------------------------------------------
cube='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
faces='f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n'
printf "$cube$faces" >"$dir/cube.obj"
numbers() { echo "{\"file\":\"$1\",\"vertices_in\":$2,\"triangles_in\":$3,\"vertices\":$4,\"triangles\":$5,\"volume\":$6}"; }
expect 'numbers of a cube' 0 "^$(numbers "$dir/cube.obj" 8 12 8 12 1)\$" "$nook" hull --json "$dir/cube.obj" "$dir/hull.obj"
expect 'and a line for people' 0 "^$dir/hull.obj: hull of 8 vertices, 12 triangles: 8 vertices, 12 triangles, volume 1\$" "$nook" hull "$dir/cube.obj" "$dir/hull.obj"
[ "$(grep '^v' "$dir/hull.obj")" = "$(printf "$cube")" ] && ok || no 'vertices stay where they are, in their order'
expect '--scale' 0 '"volume":8}' "$nook" hull --json --scale 2 "$dir/cube.obj" "$dir/hull.obj"
more='v .5 .5 .5\nv .5 .5 0\nv .5 0 0\nv 0 0 0\nv .25 .25 1\nv 1 1 1\n'
printf "$more$cube" >"$dir/cloud.obj"
expect 'a cloud of points: what lies within, on faces, on edges and twice is no vertex' 0 "^$(numbers "$dir/cloud.obj" 14 0 8 12 1)\$" "$nook" hull --json "$dir/cloud.obj" "$dir/hull.off"
printf "$cube${faces}v 9 9 9\n" >"$dir/hair.obj"
expect 'a vertex of no triangle does not count' 0 '"vertices_in":9,.*"vertices":8,"triangles":12,"volume":1}' "$nook" hull --json "$dir/hair.obj" "$dir/hull.off"
for format in stl obj off ply; do
    expect "$format on standard output" 0 '"verdict":"sound"' sh -c "'$nook' hull --format $format '$dir/cube.obj' - 2>'$dir/said' | '$nook' check --json -"
    grep -q '^-: hull of 8 vertices' "$dir/said" && ok || no "what is said moves to stderr: $(cat "$dir/said")"
done
expect '--format against the name' 0 '"format":"OBJ"' sh -c "'$nook' hull --format obj '$dir/cube.obj' '$dir/named.stl' >/dev/null && '$nook' check --json '$dir/named.stl'"
expect 'standard input' 0 'volume 1$' sh -c "'$nook' hull - '$dir/hull.off' <'$dir/cube.obj'"
"$nook" make gear -o "$dir/gear.stl" 2>/dev/null
"$nook" hull "$dir/gear.stl" "$dir/welded.off" >/dev/null 2>&1
expect 'not welded' 0 'hull of 960 vertices' "$nook" hull --weld none "$dir/gear.stl" "$dir/loose.off"
[ "$("$nook" check --json "$dir/welded.off" | grep -o '"signed_volume":[^,]*')" = "$("$nook" check --json "$dir/loose.off" | grep -o '"signed_volume":[^,]*')" ] &&
    ok || no 'the hull is the same, welded or not'

# ---- no hull -----------------------------------------------------------------------------------------
flat='no hull has a volume: the points lie in one plane'
printf 'v 0 0 3\nv 1 0 3\nv 0 1 3\nv 1 1 3\nf 1 2 3\n' >"$dir/plane.obj"
printf 'v 0 0 0\nv 1 1 1\nv 2 2 2\nv 3 3 3\nv 5 5 5\n' >"$dir/line.obj"
printf 'v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\n' >"$dir/point.obj"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$dir/three.obj"
printf 'OFF\n0 0 0\n' >"$dir/none.off"
for file in plane.obj line.obj point.obj three.obj none.off; do
    expect "$file is flat" 1 "^nook: $dir/$file: $flat\$" "$nook" hull "$dir/$file" "$dir/flat.off"
    expect "$file in numbers" 1 '"vertices":null,"triangles":null,"volume":null}' "$nook" hull --json "$dir/$file" "$dir/flat.off"
    [ -e "$dir/flat.off" ] && no "$file: a file was written" || ok
done
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0.25 0.25 1e-45\n' >"$dir/thin.obj"
expect 'flat but for the last bit is not flat' 0 '"vertices":4,"triangles":4,' "$nook" hull --json "$dir/thin.obj" "$dir/thin.off"

# ---- wrong use ---------------------------------------------------------------------------------------
expect 'no OUT' 2 '^nook: hull needs IN and OUT' "$nook" hull "$dir/cube.obj"
expect 'no IN either' 2 '^nook: hull needs IN and OUT' "$nook" hull
expect 'three files' 2 '^nook: hull needs IN and OUT' "$nook" hull "$dir/cube.obj" "$dir/cube.obj" "$dir/hull.off"
expect 'an ending of no format' 2 '^nook: no format' "$nook" hull "$dir/cube.obj" "$dir/hull.xyz"
expect 'a format that is none' 2 '^nook: the formats are' "$nook" hull --format xyz "$dir/cube.obj" "$dir/hull.off"
expect 'a mesh that is not there' 2 "^nook: $dir/absent.obj: " "$nook" hull "$dir/absent.obj" "$dir/hull.off"
expect 'a folder that is not there' 2 "^nook: $dir/absent/hull.off: " "$nook" hull "$dir/cube.obj" "$dir/absent/hull.off"
expect 'an unknown option' 2 'has no option --budget' "$nook" hull --budget 3 "$dir/cube.obj" "$dir/hull.off"
expect 'a bad scale' 2 'scale needs' "$nook" hull --scale -1 "$dir/cube.obj" "$dir/hull.off"
expect 'help' 0 'the convex hull of a mesh' "$nook" hull --help
awk 'BEGIN { for (i = 0; i < 10930; i++) printf "v %d %d %d\n", i % 23, int(i / 23) % 23, int(i / 529) }' >"$dir/many.obj"
if "$nook" --version | grep -q '16-bit'; then
    expect 'more points than 16-bit indices can serve' 2 "^nook: $dir/many.obj: 10930 points may need 21856 triangles" "$nook" hull "$dir/many.obj" "$dir/hull.off"
else
    expect 'a grid of many points' 0 '"vertices_in":10930,.*"volume":[0-9.e+]*}' "$nook" hull --json "$dir/many.obj" "$dir/hull.off"
fi
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
