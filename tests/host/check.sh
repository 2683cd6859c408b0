#!/bin/sh
# check.sh -- the program as its users meet it: shapes it makes, every defect it can make, files that
# other tools write, and files that nobody should. NOOK names the program, build/nook by default.
. tests/tools/host.sh

# expect NAME STATUS PATTERN COMMAND... : its exit status, and a pattern in what it prints
expect() {
    name=$1 status=$2 pattern=$3
    shift 3
    said=$("$@" 2>"$dir/err")
    got=$?
    if [ $got -ne "$status" ]; then no "$name: exit $got instead of $status: $said $(cat "$dir/err")"
    elif ! printf '%s\n' "$said" | grep -q -e "$pattern"; then no "$name: no '$pattern' in: $said"
    else ok; fi
}

# refuse NAME FILE : exit 2, one line on stderr that names the file, verdict unreadable
refuse() {
    expect "$1" 2 '"verdict":"unreadable"' "$nook" check --json "$2"
    if [ "$(wc -l <"$dir/err")" -eq 1 ] && grep -q "^nook: $2: " "$dir/err"; then ok; else no "$1: stderr is $(cat "$dir/err")"; fi
}

for shape in icosphere torus box capsule pipe gear; do
    for format in stl obj off ply; do
        "$nook" make $shape -o "$dir/$shape.$format" 2>"$dir/err" || no "make $shape: $(cat "$dir/err")"
        expect "a $shape in $format is sound" 0 '"verdict":"sound"' "$nook" check --json "$dir/$shape.$format"
    done
done
expect 'a torus has genus 1' 0 '"genus":1,' "$nook" check --json "$dir/torus.off"
expect 'a sphere is simple' 0 '"simple":true' "$nook" check --json "$dir/icosphere.off"
expect 'the text begins with the verdict' 0 ': sound$' "$nook" check "$dir/box.stl"

defect() { # kind, pattern
    "$nook" make icosphere --defect "$1" -o "$dir/bad.off" 2>"$dir/err" || no "make --defect $1: $(cat "$dir/err")"
    expect "defect $1 is found" 1 "$2" "$nook" check --json "$dir/bad.off"
}
defect hole '"code":"border_edge","severity":"error","count":3'
defect flipped '"code":"incoherent_edge","severity":"error","count":3'
defect inside-out '"inside_out":true'
defect duplicate '"duplicate_triangles":1'
defect nonmanifold-edge '"code":"nonmanifold_edge","severity":"error","count":1'
for shape in sheet moebius; do
    "$nook" make $shape --defect nonmanifold-edge -o "$dir/fin.obj" 2>/dev/null
    expect "a fin on the rim of a $shape" 1 '"nonmanifold_edges":1,' "$nook" check --json "$dir/fin.obj"
done
defect bow-tie '"code":"nonmanifold_vertex","severity":"error","count":1'
defect crossing '"consistent":false,.*"self_intersections":92,"t_junctions":0,.*"code":"self_intersection","severity":"error","count":92,"elements":\[{"triangle":[0-9]*,"other":[0-9]*,"position":\[[^]]*\]},'
defect degenerate '"degenerate_triangles":1'
defect zero-area '"code":"zero_area_triangle","severity":"error","count":1'
"$nook" make icosphere --defect isolated -o "$dir/isolated.off"
expect 'an isolated vertex is told and does not decide' 0 '"isolated_vertices":1' "$nook" check --json "$dir/isolated.off"
expect 'unless it is required' 1 '"isolated_vertices":1' "$nook" check --json --require no-isolated "$dir/isolated.off"

tetra='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n'
printf "${tetra}f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4" >"$dir/tetra.obj"
expect 'a last line without newline counts' 0 '"triangles":4' "$nook" check --json "$dir/tetra.obj"
printf "${tetra}f -4 -2 -3\nf 1/1 2/2/2 4//4\r\nf 2 \\\\\n3 4\nf 3 1 4\n" >"$dir/odd.obj"
expect 'negative and slashed indices and continued lines' 0 '"verdict":"sound"' "$nook" check --json "$dir/odd.obj"
printf 'OFF4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' >"$dir/glued.off"
expect 'counts glued to the magic word' 0 '"verdict":"sound"' "$nook" check --json "$dir/glued.off"
expect 'a tetrahedron is convex' 0 '"concave_edges":0,"convex_edges":6,"flat_edges":0,"folded_edges":0,"zero_area_triangles":0,"convex_witness":null,"area":2.3660254,"signed_volume":0.16666667,"centroid":\[0.25,0.25,0.25\],"inertia":\[' "$nook" check --json "$dir/tetra.obj"
expect 'and may be required to be' 0 '"convex":true' "$nook" check --require convex --json "$dir/tetra.obj"
expect 'a torus is not, and a vertex and a triangle show it' 1 '"convex_witness":{"vertex":[0-9]*,"triangle":[0-9]*}' "$nook" check --require convex --json "$dir/torus.off"
expect 'the text says where' 0 'convex     no: vertex [0-9]* is outside the plane of triangle [0-9]*$' "$nook" check "$dir/torus.off"
printf 'v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n' >"$dir/flat.obj"
expect 'a surface folded upon itself is flat and not outward' 1 '"consistent":false.*"folded_edges":[1-9].*"code":"flat_shell"' "$nook" check --json "$dir/flat.obj"
expect 'an open mesh has no volume, no centroid and no convexity' 1 '"convex":null.*"concave_edges":null,.*"signed_volume":null,"centroid":null,"inertia":null' sh -c "'$nook' make sheet -o - --format off | '$nook' check --json -"
expect 'a mesh that does not meet itself' 0 '"consistent":true,.*"self_intersections":0,"t_junctions":0,' "$nook" check --json "$dir/torus.off"
"$nook" make icosphere --defect crossing -o "$dir/crossing.off" 2>/dev/null
expect 'the text says that it does' 1 ': DEFECTIVE: 92 self-intersections$' "$nook" check "$dir/crossing.off"
expect 'and where' 1 '^      triangle [0-9]* and triangle [0-9]* at (-\{0,1\}[0-9.]*, -\{0,1\}[0-9.]*, -\{0,1\}[0-9.]*)$' "$nook" check "$dir/crossing.off"
printf 'v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 2 1 -1\nv 1 1 3\nf 1 2 3\nf 4 5 6\n' >"$dir/cut.obj"
expect 'a pair is named once, at the middle of what their boxes share' 1 '"count":1,"elements":\[{"triangle":0,"other":1,"position":\[1.5,1,0\]}\]' "$nook" check --json "$dir/cut.obj"
expect 'what is not required does not decide' 0 '"verdict":"sound"' "$nook" check --json --require watertight "$dir/crossing.off"
expect 'consistent may be required' 1 'required, but not so: consistent$' "$nook" check --require consistent "$dir/crossing.off"
expect 'pairs listed are limited, their number is not' 1 '"count":92,"elements":\[{[^{]*},{[^{]*}\]}' "$nook" check --json --max-list 2 "$dir/crossing.off"
tetra='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n' tetra_faces='f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
printf "${tetra}${tetra_faces}v 0 0 1\nv 1 0 2\nv 0 1 2\nv 0 0 2\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n" >"$dir/tips.obj"
expect 'two tips at one point meet: three triangles with three' 1 '"self_intersections":9,' "$nook" check --json "$dir/tips.obj"
awk '$0 == "v 0 0 1" && seen++ { $0 = "v 0 0 1.0000001" } { print }' "$dir/tips.obj" >"$dir/gap.obj"
expect 'the least gap is a gap' 0 '"self_intersections":0,' "$nook" check --json "$dir/gap.obj"
printf 'v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0 0\nv 1 -1 0\nf 1 2 3\nf 1 5 4\nf 4 5 2\n' >"$dir/seam.obj"
expect 'a T-junction is a warning, with its vertex and edge' 1 '"t_junctions":1,.*{"code":"t_junction","severity":"warning","count":1,"elements":\[{"vertex":3,"corner":2,"edge":\[0,1\],"position":\[1,0,0\]}\]}' "$nook" check --json "$dir/seam.obj"
expect 'for people too' 1 '^      vertex 3 on edge 0-1 of triangle 0 at (1, 0, 0)$' "$nook" check "$dir/seam.obj"
expect 'which does not decide' 0 'note: 1 T-junction: ' "$nook" check --require oriented "$dir/seam.obj"
printf 'OFF\n0 0 0\n' >"$dir/none.off"
expect 'no triangle meets no triangle' 1 '"consistent":true,.*"self_intersections":0,"t_junctions":0,' "$nook" check --json "$dir/none.off"
expect 'several files: the highest status' 1 'tetra.obj' "$nook" check --json "$dir/tetra.obj" "$dir/bad.off"
expect 'a file named by -' 0 '"verdict":"sound"' sh -c "'$nook' check --json - <'$dir/tetra.obj'"
expect 'the digest is the same in every format' 0 "$("$nook" check --json "$dir/torus.off" | grep -o '"digest":"[0-9a-f]*"')" "$nook" check --json "$dir/torus.ply"

: >"$dir/empty.stl"
refuse 'a file of no bytes' "$dir/empty.stl"
head -c 1000 "$dir/icosphere.stl" >"$dir/cut.stl"
refuse 'a truncated STL' "$dir/cut.stl"
printf "${tetra}f 1 2 9\n" >"$dir/range.obj"
refuse 'an index out of range' "$dir/range.obj"
printf "${tetra}f 0 1 2\n" >"$dir/zero.obj"
refuse 'index 0 of an OBJ' "$dir/zero.obj"
printf 'v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$dir/nan.obj"
refuse 'a NaN' "$dir/nan.obj"
printf 'v 0 0 1,5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$dir/comma.obj"
refuse 'a decimal comma' "$dir/comma.obj"
printf 'OFF\n4000000000 4000000000 0\n0 0 0\n' >"$dir/huge.off"
refuse 'counts beyond the bytes present' "$dir/huge.off"
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 4294967295\nend_header\n' >"$dir/rows.ply"
refuse 'rows of no bytes without an end' "$dir/rows.ply"
printf 'ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uint uint vertex_indices\nend_header\n\377\377\377\377' >"$dir/list.ply"
refuse 'a list longer than the file' "$dir/list.ply"
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n' >"$dir/cut-ascii.stl"
refuse 'a facet cut off' "$dir/cut-ascii.stl"
printf 'Hello, world. This is not a mesh.\n' >"$dir/text.obj"
refuse 'a text of no format' "$dir/text.obj"
refuse 'a file that does not exist' "$dir/none.stl"

expect 'an unknown command' 2 '' "$nook" polish "$dir/tetra.obj"
expect 'a command that is still to come' 2 '' "$nook" repair a b
expect 'an unknown option' 2 '' "$nook" check --frobnicate "$dir/tetra.obj"
expect 'no file' 2 '' "$nook" check
expect 'help' 0 'check' "$nook" --help
expect 'help of a command' 0 'weld' "$nook" check --help
expect 'version' 0 '0\.1\.0' "$nook" --version

# ---- for tests/host/check.sh, before the last two lines
tetra='v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n'
faces='f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'
tab=$(printf '\t') bad=$(printf 'x\377\303(')
for name in 'a\b"c' "t${tab}t" "$bad"; do printf "$tetra$faces" >"$dir/$name.obj"; done
expect 'JSON: quotes and backslashes of a name' 0 'a\\\\b\\"c\.obj"' "$nook" check --json "$dir/a\\b\"c.obj"
expect 'JSON: control characters of a name' 0 't\\u0009t\.obj"' "$nook" check --json "$dir/t${tab}t.obj"
expect 'JSON: bytes that are no UTF-8' 0 'x\\ufffd\\ufffd(\.obj"' "$nook" check --json "$dir/$bad.obj"
expect 'several files: the highest status, whichever comes last' 1 'tetra.obj' "$nook" check --json "$dir/bad.off" "$dir/tetra.obj"
"$nook" make icosphere --defect hole -o "$dir/hole.off" 2>/dev/null
expect 'a total counts what is not listed' 1 '"border_edge","severity":"error","count":3,"elements":\[{[^{]*}\]}' "$nook" check --json --max-list 1 "$dir/hole.off"
"$nook" make icosphere --defect degenerate -o "$dir/deg.off" 2>/dev/null
expect 'and a total of dropped triangles too' 1 '"code":"repeated_vertex","severity":"error","count":1,"elements":\[\]' "$nook" check --json --max-list 0 "$dir/deg.off"
printf "${tetra}f -4 -2 -3\nf -4 -3 -1\nv 5 5 5\nf 2 3 4\nf 3 1 4\n" >"$dir/back.obj"
expect 'negative indices count from where they stand' 0 '"verdict":"sound"' "$nook" check --json "$dir/back.obj"
printf 'v 0 0 0\r\nv 1 0 0\r\nv 0 1 0 \r\nf 1 2 9\r\n' >"$dir/crlf.obj"
expect 'CR LF ends one line' 2 '"line":4,' "$nook" check --json "$dir/crlf.obj"
"$nook" check "$dir/crlf.obj" 2>&1 | grep -q ', line 4, triangle 0$' && ok || no 'the line is named on stderr'
points='\377\0\0\001\0\0\0\001\0\0\0\001' # four vertices of three chars: (-1 0 0) (1 0 0) (0 1 0) (0 0 1)
head='element vertex 4\nproperty char x\nproperty char y\nproperty char z\nelement face 4\nproperty list uchar ushort vertex_indices\nend_header\n'
little='\3\0\0\2\0\1\0\3\0\0\1\0\3\0\3\1\0\2\0\3\0\3\2\0\0\0\3\0' big='\3\0\0\0\2\0\1\3\0\0\0\1\0\3\3\0\1\0\2\0\3\3\0\2\0\0\0\3'
printf "ply\nformat binary_little_endian 1.0\n$head$points$little" >"$dir/little.ply"
printf "ply\nformat binary_big_endian 1.0\n$head$points$big" >"$dir/big.ply"
printf "ply\r\nformat binary_little_endian 1.0\r\n$(printf '%s' "$head" | sed 's/\\n/\\r\\n/g')$points$little" >"$dir/crlf.ply"
for ply in little big crlf; do
    expect "a $ply ply of chars and shorts" 0 '"verdict":"sound".*"bbox_min":\[-1,0,0\],"bbox_max":\[1,1,1\]' "$nook" check --json "$dir/$ply.ply"
done
printf 'OFF # c\n4 4 6 # c\n# c\n0 0 0 # c\n1 0 0 9 9\n0 1 0\n0 0 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 2 0 3 # c\n' >"$dir/comments.off"
expect 'comments and colours of an OFF' 0 '"verdict":"sound"' "$nook" check --json "$dir/comments.off"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n' >"$dir/quads.obj"
expect 'a cube of quads' 0 '"triangles":12,.*"signed_volume":1,' "$nook" check --json "$dir/quads.obj"
expect '--scale scales' 0 '"signed_volume":1000,.*"bbox_max":\[10,10,10\]' "$nook" check --json --scale 10 "$dir/quads.obj"
expect '--scale 0 is none' 2 '' "$nook" check --scale 0 "$dir/quads.obj"
expect 'a flat shell is not outward' 1 '"outward":false' "$nook" check --json "$dir/flat.obj"
"$nook" make icosphere --defect zero-area -o "$dir/zero-area.off" 2>/dev/null
expect 'a triangle without area is degenerate' 1 '"verdict":"defective"' "$nook" check --json --require no-degenerate "$dir/zero-area.off"
"$nook" make sheet -o "$dir/sheet.off" 2>/dev/null
expect 'what is undefined is not met' 1 '"verdict":"defective"' "$nook" check --json --require convex "$dir/sheet.off"
mkdir "$dir/folder" && for name in c a b .h; do cp "$dir/quads.obj" "$dir/folder/$name.obj"; done
expect 'a folder: its meshes in the order of their names' 0 '^a\.obj b\.obj c\.obj $' sh -c "'$nook' check --json '$dir/folder' 2>/dev/null | sed 's/.*folder.\([^\"]*\)\".*/\1/' | tr '\n' ' '"
if [ -w /dev/full ]; then expect 'output that cannot be written' 2 '' sh -c "'$nook' check '$dir/quads.obj' >/dev/full"; fi
printf 'v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n' >"$dir/one.obj"
expect 'an edge is named by its ends and its middle' 1 '{"corner":0,"edge":\[1,2\],"position":\[2,2,0\]},{"corner":1,"edge":\[2,0\],"position":\[0,2,0\]}' "$nook" check --json "$dir/one.obj"
printf 'v 1e3 -inf 0\nf 1 1 1\n' >"$dir/inf.obj"
expect '-inf is not finite' 2 '"code":"not_finite"' "$nook" check --json "$dir/inf.obj"
printf "${tetra}f 1 1 2\nf 1 3 2\nf 1 2 4\nf 2 2 1\nf 2 3 4\nf 3 1 4\nf 1 2\n" >"$dir/dropped.obj"
expect 'dropped triangles are named as in the file' 1 '"count":2,"elements":\[{"triangle":0,[^}]*},{"triangle":3,' "$nook" check --json "$dir/dropped.obj"
"$nook" check "$dir/dropped.obj" 2>&1 | grep -q 'note: 1 face of fewer than 3 corners skipped' && ok || no 'a face of two corners is noted'
expect 'a truncated STL names the first facet missing' 2 '"byte":1000,"line":null,"element":"triangle 18"' "$nook" check --json "$dir/cut.stl"
printf "\357\273\277$tetra$faces" >"$dir/bom.obj"
expect 'a mark of UTF-8 is skipped' 0 '"verdict":"sound"' "$nook" check --json "$dir/bom.obj"
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty float y\nproperty float z\nend_header\n\0\0\0\0\0\0\360\177\0\0\0\0\0\0\0\0' >"$dir/inf.ply"
expect 'an infinite double is not finite' 2 '"code":"not_finite"' "$nook" check --json "$dir/inf.ply"
printf 'ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement face 3\nproperty list uchar uint vertex_indices\nend_header\n\0\0\0' >"$dir/empty.ply"
expect 'lists may be empty' 1 '"triangles":0,' "$nook" check --json "$dir/empty.ply"
printf 'v 1000.00006 8.388609 1.00000012\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$dir/digits.obj"
expect 'nine digits where nine are needed' 1 '"bbox_max":\[1000.00006,8.388609,1.0000001\]' "$nook" check --json "$dir/digits.obj"
"$nook" make icosphere --defect unwelded -o "$dir/loose.off" 2>/dev/null
"$nook" check "$dir/loose.off" 2>/dev/null | grep -q 'hint: 798 vertices repeat' && ok || no 'the hint counts vertices to join'
"$nook" check --weld exact "$dir/hole.off" 2>/dev/null | grep -q 'hint' && no 'a hint though welded' || ok
printf 'v 100.80000305175781 -0.10227286070585251 -0.6000000238418579\nv 99.49482727050781 -0.16715233027935028 0.3788813352584839\nv 100.64140319824219 -0.125 -0.48105019330978394\nv 99.5 -0.5 0.37500080466270447\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n' >"$dir/paper.obj"
expect 'a mass that is not known is null' 0 '"centroid":null,"inertia":null' sh -c "'$nook' check --json '$dir/paper.obj' || true"
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
