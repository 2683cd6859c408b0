#!/bin/sh
# smooth.sh -- smoothed files: what is joined stays joined, noise goes, volumes and distances are those of the files, and every
# way of wrong use. NOOK names the program, build/nook by default.
. tests/tools/host.sh

# number NAME TEXT: a member of a JSON object
number() { printf '%s' "$2" | sed -n "s/.*\"$1\":\([^,}]*\).*/\1/p"; }
# holds EXPRESSION: of numbers
holds() { awk "BEGIN { exit !($1) }"; }

for shape in icosphere torus box capsule pipe gear tetrahedron moebius; do
    "$nook" make $shape -o "$dir/$shape.off" 2>/dev/null
    for way in '' '--method laplace' '--slide --method=laplace --iterations 3'; do
        said=$("$nook" smooth --json $way "$dir/$shape.off" "$dir/out.off") && ok || no "$shape $way: exit $?"
        before=$("$nook" check --json "$dir/$shape.off") after=$("$nook" check --json "$dir/out.off")
        for name in vertices triangles edges border_edges border_loops components euler watertight oriented; do
            [ "$(number $name "$before")" = "$(number $name "$after")" ] && ok || no "$shape $way: $name differs"
        done
        volume=$(number signed_volume "$before")
        [ "$(number volume_in "$said")" = "$volume" ] && ok || no "$shape $way: volume_in is not $volume: $said"
        [ "$volume" = null ] && continue
        gained=$(number volume_gained "$said") now=$(number signed_volume "$after") drift=$(number volume_drift "$said")
        holds "($volume + $gained - $now) ^ 2 <= (1e-6 * ($volume + 0)) ^ 2" && ok || no "$shape $way: $volume + $gained is not $now"
        holds "($gained / $volume - $drift) ^ 2 < 1e-12" && ok || no "$shape $way: a drift of $drift: $said"
    done
done

# ---- noise, and how far it went -------------------------------------------------------------------
"$nook" make icosphere --triangles 1280 -o "$dir/ball.off" 2>/dev/null
awk 'NR > 2 && NF == 3 { seed = (seed * 1103 + 12345) % 65536; s = 1 + (seed / 65536 - 0.5) / 10; print $1 * s, $2 * s, $3 * s; next } { print }' \
    "$dir/ball.off" >"$dir/noise.off"
area() { number area "$("$nook" check --json "$1")"; }
said=$("$nook" smooth --json "$dir/noise.off" "$dir/taubin.off")
holds "$(number volume_drift "$said") ^ 2 < 0.05 ^ 2" && ok || no "Taubin keeps the volume: $said"
holds "$(area "$dir/taubin.off") < 0.97 * $(area "$dir/noise.off")" && ok || no "Taubin: the area is $(area "$dir/taubin.off")"
distance=$(number distance "$said")
holds "$distance > 0.01 && $distance < 0.1" && ok || no "a distance of $distance"
sed -n '3,644s/^\([^ ]*\) \([^ ]*\) \([^ ]*\)$/{"point":[\1,\2,\3]}/p' "$dir/taubin.off" >"$dir/points"
most=$("$nook" query "$dir/noise.off" <"$dir/points" | sed 's/.*"distance":\([^,]*\),.*/\1/' | sort -g | tail -1)
[ "$most" = "$distance" ] && ok || no "the distance is $distance, but query says $most"
line=", no farther than $(number deviation "$said"), vertices $distance; volume"
said=$("$nook" smooth --json --method laplace "$dir/noise.off" "$dir/laplace.off")
holds "$(number volume_drift "$said") < -0.1" && ok || no "Laplace shrinks: $said"
expect 'a line for people' 0 "^$dir/out.off: 642 vertices, 1280 triangles$line [0-9.]*, gained [-0-9.]*\$" \
    "$nook" smooth "$dir/noise.off" "$dir/out.off"
cmp -s "$dir/out.off" "$dir/taubin.off" && ok || no 'twice is not the same'
expect '--iterations 0 changes nothing' 0 '"iterations":0,.*"volume_gained":0,"volume_drift":0,"deviation":0,"distance":0}' "$nook" smooth --json --iterations 0 "$dir/noise.off" "$dir/out.off"
cut=$("$nook" smooth --json --scale 2 --iterations 0 "$dir/ball.off" "$dir/out.off")
holds "$(number volume_in "$cut") > 30" && ok || no "--scale: $cut"

# ---- borders ----------------------------------------------------------------------------------------
printf 'v 0 0 0\nv 2 0 0\nv 4 0 0\nv 0 2 0\nv 3 2 1\nv 4 2 0\nv 0 4 0\nv 2 4 0\nv 4 4 0\nf 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n' >"$dir/sheet.obj"
expect 'a sheet' 0 '"held_triangles":0,"volume_in":null,"volume_gained":[-0-9.e]*,"volume_drift":null,' "$nook" smooth --json "$dir/sheet.obj" "$dir/out.obj"
[ "$(grep '^v' "$dir/sheet.obj" | sed 5d)" = "$(grep '^v' "$dir/out.obj" | sed 5d)" ] && ok || no 'a border moved'
expect 'one vertex of it, all the way' 0 '^' "$nook" smooth --method laplace --iterations 60 "$dir/sheet.obj" "$dir/out.obj"
holds "$(sed -n '5s/v .* //p' "$dir/out.obj") < 1e-6" && ok || no "it is not in the plane: $(sed -n 5p "$dir/out.obj")"
expect 'a border that slides sweeps nothing' 0 '"volume_in":null,"volume_gained":null,' "$nook" smooth --json --slide "$dir/sheet.obj" "$dir/out.obj"
grep -q '^v 0 0 0$' "$dir/out.obj" && no 'no border moved' || ok

# The tip of a cone on a border that stays goes down to it; what becomes of the tip was near a side of the cone, the tip is near nothing.
printf 'OFF\n5 4 0\n0 0 5\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1\n' >"$dir/cone.off"
said=$("$nook" smooth --json --method laplace --iterations 20 "$dir/cone.off" "$dir/out.off")
holds "$(number distance "$said") < 1 && $(number deviation "$said") > 4.9" && ok || no "a tip that goes: $said"

# ---- formats and pipes ------------------------------------------------------------------------------
for format in stl obj off ply; do
    expect "$format on standard output" 0 '"verdict":"sound"' sh -c "'$nook' smooth --format $format '$dir/ball.off' - 2>'$dir/said' | '$nook' check --json -"
    grep -q '^-: 642 vertices' "$dir/said" && ok || no "what is said moves to stderr: $(cat "$dir/said")"
done
expect 'standard input' 0 '642 vertices' sh -c "'$nook' smooth - '$dir/out.off' <'$dir/ball.off'"

# ---- wrong use --------------------------------------------------------------------------------------
expect 'no OUT' 2 '^nook: smooth needs IN and OUT' "$nook" smooth "$dir/ball.off"
expect 'another method' 2 '^nook: --method is taubin or laplace, not best' "$nook" smooth --method best "$dir/ball.off" "$dir/no.off"
expect 'rounds that are no number' 2 '^nook: --iterations needs a count' "$nook" smooth --iterations -1 "$dir/ball.off" "$dir/no.off"
expect 'an unknown option' 2 'has no option --budget' "$nook" smooth --budget 3 "$dir/ball.off" "$dir/no.off"
expect 'an ending of no format' 2 '^nook: no format' "$nook" smooth "$dir/ball.off" "$dir/no.xyz"
expect 'a bad scale' 2 'scale needs' "$nook" smooth --scale 0 "$dir/ball.off" "$dir/no.off"
expect 'a mesh that is not there' 2 "^nook: $dir/absent.obj: " "$nook" smooth "$dir/absent.obj" "$dir/no.off"
expect 'a folder that is not there' 2 "^nook: $dir/absent/out.off: " "$nook" smooth "$dir/ball.off" "$dir/absent/out.off"
printf 'OFF\n1 0 0\n0 0 0\n' >"$dir/none.off"
expect 'no triangle' 2 "^nook: $dir/none.off: no triangle\$" "$nook" smooth "$dir/none.off" "$dir/no.off"
[ -e "$dir/no.off" ] && no 'something was written' || ok
expect 'help' 0 'a mesh without its noise' "$nook" smooth --help
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
