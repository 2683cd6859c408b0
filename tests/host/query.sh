#!/bin/sh
# query.sh -- questions to a mesh, line by line: every kind of answer, every key of it, every way to ask wrongly, and
# what a budget leaves open. NOOK names the program, build/nook by default.
. tests/tools/host.sh

# ask NAME QUESTIONS ANSWERS [OPTION...] FILE : exit 0, and exactly these lines
ask() {
    name=$1 wanted=$3
    printf "$2" >"$dir/in"
    shift 3
    said=$("$nook" query "$@" <"$dir/in" 2>"$dir/err")
    got=$?
    if [ $got -ne 0 ]; then no "$name: exit $got: $said $(cat "$dir/err")"
    elif [ "$said" != "$(printf '%b' "$wanted")" ]; then no "$name: not '$wanted' but: $said"
    else ok; fi
}

# matches NAME QUESTION PATTERN [OPTION...] FILE : exit 0, and a pattern in what is said
matches() {
    name=$1 pattern=$3
    printf '%s\n' "$2" >"$dir/in"
    shift 3
    said=$("$nook" query "$@" <"$dir/in" 2>"$dir/err")
    got=$?
    if [ $got -ne 0 ]; then no "$name: exit $got: $said $(cat "$dir/err")"
    elif ! printf '%s\n' "$said" | grep -q -e "$pattern"; then no "$name: no '$pattern' in: $said"
    else ok; fi
}

# refuse NAME LINE WHAT : after a good line, this one ends it with exit 2 and says what and where, on one line
refuse() {
    { printf '{"point":[2,0.5,0.25]}\n'; printf '%b' "$2"; } >"$dir/in"
    said=$("$nook" query "$dir/cube.obj" <"$dir/in" 2>"$dir/err")
    got=$?
    if [ $got -ne 2 ]; then no "$1: exit $got instead of 2: $said"
    elif [ "$(cat "$dir/err")" != "nook: <stdin>: $3, line 2" ]; then no "$1: stderr is $(cat "$dir/err")"
    elif [ "$(printf '%s\n' "$said" | wc -l)" -ne 1 ] || [ "${said#*\"side\":1}" = "$said" ]; then no "$1: answers: $said"
    else ok; fi
}

# usage NAME WHAT COMMAND... : exit 2, one line
usage() {
    name=$1 what=$2
    shift 2
    said=$("$@" </dev/null 2>&1)
    got=$?
    if [ $got -ne 2 ] || [ "$(printf '%s\n' "$said" | wc -l)" -ne 1 ]; then no "$name: exit $got: $said"
    elif ! printf '%s\n' "$said" | grep -q -e "$what"; then no "$name: no '$what' in: $said"
    else ok; fi
}

cube='v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n'
faces='f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n'
printf "$cube$faces" >"$dir/cube.obj"
printf "${cube}f 4 3 2 1\nf 1 2 6 5\n" >"$dir/open.obj"

# ---- answers of a cube ----------------------------------------------------------------------------
cube=$dir/cube.obj
ask 'a point outside' '{"point":[2,0.5,0.25]}' '{"side":1,"distance":1,"closest":[1,0.5,0.25],"triangle":6}' "$cube"
ask 'a point inside' '{"point":[0.875,0.5,0.25]}' '{"side":-1,"distance":0.125,"closest":[1,0.5,0.25],"triangle":6}' "$cube"
ask 'a point on the surface' '{"point":[1,0.5,0.25]}' '{"side":0,"distance":0,"closest":[1,0.5,0.25],"triangle":6}' "$cube"
ask 'a vertex is on the surface, of its triangles the first is named' '{"point":[0,0,0]}' '{"side":0,"distance":0,"closest":[0,0,0],"triangle":1}' "$cube"
matches 'nearest to a vertex' '{"point":[4,5,1]}' '"side":1,"distance":5,"closest":\[1,1,1\]' "$cube"
ask 'a ray that hits' '{"ray":{"origin":[0.75,0.25,3],"direction":[0,0,-1]}}' \
    '{"hit":true,"t":2,"triangle":2,"normal":[0,0,1],"barycentric":[0.25,0.5,0.25]}' "$cube"
ask 't is in units of the direction' '{"ray":{"direction":[0,0,-4],"origin":[0.75,0.25,3]}}' \
    '{"hit":true,"t":0.5,"triangle":2,"normal":[0,0,1],"barycentric":[0.25,0.5,0.25]}' "$cube"
ask 'a ray that misses' '{"ray":{"origin":[0.75,0.25,3],"direction":[0,0,1]}}' '{"hit":false,"t":null,"triangle":null}' "$cube"
matches 'from inside it hits too' '{"ray":{"origin":[0.75,0.25,0.5],"direction":[0,0,-1]}}' '"hit":true,"t":0.5,.*"normal":\[-\{0,1\}0,-\{0,1\}0,-1\]' "$cube"
matches 'along an edge' '{"ray":{"origin":[-1,0,0],"direction":[1,0,0]}}' '"hit":true,"t":1,' "$cube"
matches 'at a vertex' '{"ray":{"origin":[3,3,3],"direction":[-1,-1,-1]}}' '"hit":true,"t":2,' "$cube"
ask 'a capsule that touches' '{"segment":[[2,0.5,0.25],[3,0.5,0.25]],"radius":1}' \
    '{"distance":1,"closest":[1,0.5,0.25],"on":[2,0.5,0.25],"triangle":6,"touches":true}' "$cube"
ask 'and one that is clear' '{"radius":0.5,"segment":[[3,0.5,0.25],[2,0.5,0.25]]}' \
    '{"distance":1,"closest":[1,0.5,0.25],"on":[2,0.5,0.25],"triangle":6,"touches":false}' "$cube"
matches 'a segment through the surface, without a radius' '{"segment":[[0.5,0.5,0.25],[3,0.5,0.25]]}' '"distance":0,.*"touches":true' "$cube"
matches 'a sphere' '{"segment":[[2,0.5,0.25],[2,0.5,0.25]],"radius":0.75}' '"distance":1,.*"touches":false' "$cube"
ask 'one answer a line, in order' '{"point":[2,0.5,0.25]}\n{"ray":{"origin":[0.75,0.25,3],"direction":[0,0,1]}}\n{"point":[0.875,0.5,0.25]}\n' \
    '{"side":1,"distance":1,"closest":[1,0.5,0.25],"triangle":6}\n{"hit":false,"t":null,"triangle":null}\n{"side":-1,"distance":0.125,"closest":[1,0.5,0.25],"triangle":6}' "$cube"
ask '--scale scales the mesh' '{"point":[4,1,0.5]}' '{"side":1,"distance":2,"closest":[2,1,0.5],"triangle":6}' --scale 2 "$cube"
ask '--json changes nothing' '{"point":[2,0.5,0.25]}' '{"side":1,"distance":1,"closest":[1,0.5,0.25],"triangle":6}' --json "$cube"
matches 'no inside: side is null' '{"point":[0.5,0.25,0.5]}' '^{"side":null,"distance":0.25,"closest":\[0.5,0,0.5\],"triangle":[23]}$' "$dir/open.obj"
"$nook" make box -o "$dir/box.stl" 2>/dev/null
matches 'an STL is welded' '{"point":[9,0,0]}' '"side":1,' "$dir/box.stl"
matches 'unless --weld none: then nothing is closed' '{"point":[9,0,0]}' '"side":null,' --weld none "$dir/box.stl"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\nf 1 2 3\n' >"$dir/dropped.obj"
matches 'triangles are numbered without the degenerate ones' '{"point":[0.25,0.25,1]}' '"triangle":0}' "$dir/dropped.obj"

# ---- lines ----------------------------------------------------------------------------------------
far='{"side":1,"distance":1,"closest":[1,0.5,0.25],"triangle":6}'
ask 'no question, no answer' '' '' "$cube"
ask 'empty lines are skipped' '\n  \t\n{"point":[2,0.5,0.25]}\n\r\n' "$far" "$cube"
ask 'blanks, CR LF and a last line without an end' ' { "point" :\t[ 2 , 0.5,0.25 ] } \r\n{"point":[2,0.5,0.25]}' "$far\n$far" "$cube"
ask 'other keys are ignored' '{"id":[{"a":[]},"\\u00e9\\n\\"",-1.5e-3,true,false,null,{}],"point":[2,0.5,0.25],"note":1e999}' "$far" "$cube"
ask 'of a ray too' '{"ray":{"id":"x","origin":[0.75,0.25,3],"direction":[0,0,1],"t":[]}}' '{"hit":false,"t":null,"triangle":null}' "$cube"
ask 'numbers of many digits, near enough' '{"point":[2.0000000000000000000000000000000000000000000000001,5e-1,0.025E+1]}' "$far" "$cube"
ask 'the smallest number and beyond' '{"ray":{"origin":[0.75,0.25,3],"direction":[1e-400,0,1e-45]}}' '{"hit":false,"t":null,"triangle":null}' "$cube"
matches 'a coordinate of 2^30' '{"point":[1073741824,0,0]}' '"side":1,"distance":1073741824,' "$cube"
deep=$(awk 'BEGIN { for (i = 0; i < 64; i++) s = s "["; for (i = 0; i < 64; i++) s = s "]"; print s }')
ask '64 brackets deep' "{\"deep\":$deep,\"point\":[2,0.5,0.25]}" "$far" "$cube"

missing='a number is missing'
refuse 'deeper' "{\"deep\":[$deep],\"point\":[2,0.5,0.25]}" 'nested too deep'
awk 'BEGIN { for (i = 0; i < 100000; i++) printf "["; print "" }' >"$dir/brackets"
usage 'a hundred thousand brackets' 'not a JSON object, line 1$' sh -c "'$nook' query '$cube' <'$dir/brackets'"
awk 'BEGIN { printf "{\"a\":"; for (i = 0; i < 100000; i++) printf "{\"a\":["; print "" }' >"$dir/brackets"
usage 'and of objects' 'nested too deep, line 1$' sh -c "'$nook' query '$cube' <'$dir/brackets'"
awk 'BEGIN { printf "{\"point\":[2,0.5,0.25"; for (i = 0; i < 100000; i++) printf "0000000000"; print "]}" }' >"$dir/digits"
usage 'a number of a million digits' ': the line is longer than 1 MiB, line 1$' sh -c "cat '$dir/digits' '$dir/digits' | tr -d '\\n' | '$nook' query '$cube'"
sed 's/0\]/]/' "$dir/digits" >"$dir/digits2"
[ "$("$nook" query "$cube" <"$dir/digits2" 2>&1)" = "$far" ] && ok || no 'a line of a megabyte'
refuse 'no JSON' 'hello' 'not a JSON object'
refuse 'an array' '[1,2,3]' 'not a JSON object'
refuse 'cut off' '{"point":[1,2,3]' 'a comma or } is missing'
refuse 'cut off earlier' '{"point":[1,2,' "$missing"
refuse 'cut off in a key' '{"poi' 'a string without an end'
refuse 'more than an object' '{"point":[1,2,3]} {}' 'more on the line than an object'
refuse 'an empty object' '{}' 'neither a point nor a ray nor a segment'
refuse 'no known key' '{"Point":[1,2,3]}' 'neither a point nor a ray nor a segment'
refuse 'two questions' '{"point":[1,2,3],"ray":{"origin":[0,0,0],"direction":[0,0,1]}}' 'more than one question on a line'
refuse 'no colon' '{"point" [1,2,3]}' 'a colon is missing'
refuse 'no comma' '{"x":1 "point":[1,2,3]}' 'a comma or } is missing'
refuse 'a comma too many' '{"point":[1,2,3],}' 'a string in quotes is missing'
refuse 'a key without quotes' '{point:[1,2,3]}' 'a string in quotes is missing'
refuse 'no array' '{"point":1}' 'an array of numbers is missing'
refuse 'two numbers' '{"point":[1,2]}' 'an array with too few numbers'
refuse 'four numbers' '{"point":[1,2,3,4]}' 'an array does not end where it should'
refuse 'a text for a number' '{"point":[1,2,"3"]}' "$missing"
for number in + +1 01 .5 5. 1e 1e+ - -- 0x1 1_0 1,5 true '1\0000' '\0377'; do
    case $number in 1,5 | '1\0000') what='an array does not end where it should' ;; *) what=$missing ;; esac
    refuse "$number is no number" "{\"point\":[1,2,$number]}" "$what"
done
for number in NaN nan Infinity -Infinity -inf 1e400 -1e400 1e39 1e99999999999999999999; do
    refuse "$number is not finite" "{\"point\":[1,2,$number]}" 'a number that is no finite float32'
done
refuse 'beyond 2^30' '{"point":[1,2,1073741952]}' 'a coordinate larger than 2^30'
refuse 'an origin beyond 2^30' '{"ray":{"origin":[-2e9,0,0],"direction":[0,0,1]}}' 'a coordinate larger than 2^30'
refuse 'an end beyond 2^30' '{"segment":[[0,0,0],[0,2e9,0]],"radius":1}' 'a coordinate larger than 2^30'
refuse 'a ray that is no object' '{"ray":[0,0,0]}' 'a ray must be an object'
refuse 'a ray without an origin' '{"ray":{"direction":[0,0,1]}}' 'a ray without an origin'
refuse 'a ray without a direction' '{"ray":{"origin":[0,0,1]}}' 'a ray without a direction'
refuse 'a direction of 0' '{"ray":{"origin":[0,0,1],"direction":[0,-0.0,1e-60]}}' 'a direction of 0'
refuse 'a direction that is not finite' '{"ray":{"origin":[0,0,1],"direction":[0,0,1e39]}}' 'a number that is no finite float32'
for segment in 1 '[]' '[[0,0,0]]' '[[0,0,0],[1,1,1],[2,2,2]]'; do
    case $segment in '[]') what='an array of numbers is missing' ;; *) what='a segment must be an array of two points' ;; esac
    refuse "$segment is no segment" "{\"segment\":$segment,\"radius\":1}" "$what"
done
refuse 'a negative radius' '{"segment":[[0,0,0],[1,1,1]],"radius":-1}' 'a negative radius'
refuse 'a radius that is no number' '{"segment":[[0,0,0],[1,1,1]],"radius":null}' "$missing"
refuse 'a control character' '{"a\0001":1,"point":[1,2,3]}' 'a control character in a string'
refuse 'a bad escape' '{"a\\q":1,"point":[1,2,3]}' 'a bad escape in a string'
refuse 'a cut escape' '{"a\\u12' 'a bad escape in a string'
refuse 'a bad value of another key' '{"a":tru,"point":[1,2,3]}' 'a value is missing'
refuse 'an array that does not close' '{"a":[1 2],"point":[1,2,3]}' 'a comma or ] is missing'
refuse 'an array closed as an object' '{"a":[1},"point":[1,2,3]}' 'a comma or ] is missing'

# ---- usage ----------------------------------------------------------------------------------------
usage 'no file' 'query needs one file' "$nook" query
usage 'two files' 'query needs one file' "$nook" query "$cube" "$cube"
usage 'standard input is for questions' 'standard input' "$nook" query -
usage 'a mesh that is not there' "^nook: $dir/none.obj: " "$nook" query "$dir/none.obj"
printf 'v 0 0 0\n' >"$dir/empty.obj"
usage 'a mesh of no triangle' "^nook: $dir/empty.obj: no triangle" "$nook" query "$dir/empty.obj"
usage 'an unknown option' 'has no option --max-list' "$nook" query --max-list 3 "$cube"
usage 'a budget that is no count' 'budget needs a count' "$nook" query --budget -1 "$cube"
usage 'a bad scale' 'scale needs' "$nook" query --scale x "$cube"
usage 'standard input that is a folder' '^nook: <stdin>: ' sh -c "'$nook' query '$cube' <'$dir'"
"$nook" query --help | grep -q -e '--budget N' && ok || no 'help of query'
if [ -w /dev/full ]; then usage 'answers that cannot be written' 'cannot be written' sh -c "echo '{\"point\":[1,2,3]}' | '$nook' query '$cube' >/dev/full"; fi

# A pipe is answered line by line: the second question is asked when the first answer is there.
mkfifo "$dir/questions" "$dir/answers"
"$nook" query "$cube" <"$dir/questions" >"$dir/answers" 2>"$dir/err" &
exec 8>"$dir/questions" 9<"$dir/answers"
for number in 1 2; do
    printf '{"point":[2,0.5,0.25]}\n' >&8
    said=
    read -r said <&9
    [ "$said" = "$far" ] && ok || no "answer $number of a pipe: $said"
done
exec 8>&- 9<&-
wait $! && ok || no "a pipe that ends: exit $?"

# ---- budgets --------------------------------------------------------------------------------------
ask 'a budget that suffices changes nothing' '{"point":[2,0.5,0.25]}' "$far" --budget 1000 "$cube"
"$nook" make torus --triangles 4000 -o "$dir/torus.off" 2>/dev/null
torus=$dir/torus.off
number='-\{0,1\}[0-9.e+-]*' place='\(null\|\[[^]]*\]\)'
bounds="\"complete\":false,\"distance_min\":$number,\"distance_max\":$number,\"closest\":$place"
matches 'a point without a step' '{"point":[0.5,0.25,0.125]}' "^{\"side\":null,$bounds,\"triangle\":[0-9nul]*}\$" --budget 0 "$torus"
matches 'without an inside all steps are for the distance' '{"point":[0.5,0.25,0.5]}' '^{"side":null,"distance":0.25,' --budget 6 "$dir/open.obj"
ray='{"ray":{"origin":[3,0.25,0.125],"direction":[-1,0,0]}}'
matches 'a ray without a step' "$ray" "^{\"hit\":null,\"complete\":false,\"t_min\":$number,\"t\":null,\"triangle\":null}\$" --budget 0 "$torus"
matches 'a ray without a budget' "$ray" "^{\"hit\":true,\"t\":$number,\"triangle\":[0-9]*,\"normal\":$place,\"barycentric\":$place}\$" "$torus"
capsule() { echo "{\"segment\":[[3,0.5,0.25],[4,0,0]],\"radius\":$1}"; }
capsule_bounds="^{$bounds,\"on\":$place,\"triangle\":[0-9nul]*,\"touches\":"
matches 'a capsule without a step' "$(capsule 1.8)" "${capsule_bounds}null}\$" --budget 0 "$torus"
matches 'that is surely clear' "$(capsule 0.01)" "${capsule_bounds}false}\$" --budget 3 "$torus"
matches 'that surely touches' "$(capsule 9)" "${capsule_bounds}true}\$" --budget 0 "$torus"

# Whatever the budget: what is known bounds what is so, and is said in one of these forms.
form_of() { # kind
    case $1 in
    'a side and no distance') echo "^{\"side\":-\{0,1\}[01],$bounds,\"triangle\":[0-9]*}\$" ;;
    'neither side nor distance') echo "^{\"side\":null,$bounds,\"triangle\":[0-9nul]*}\$" ;;
    'no hit so far') echo "^{\"hit\":null,\"complete\":false,\"t_min\":$number,\"t\":null,\"triangle\":null}\$" ;;
    'a hit so far') echo "^{\"hit\":true,\"complete\":false,\"t_min\":$number,\"t\":$number,\"triangle\":[0-9]*,\"normal\":$place,\"barycentric\":$place}\$" ;;
    'a capsule') echo "${capsule_bounds}[a-z]*}\$" ;;
    esac
}
awk 'BEGIN {
    srand(1)
    for (i = 0; i < 40; i++) {
        for (k = 0; k < 6; k++) x[k] = sprintf("%.3f", 4 * rand() - 2)
        print "{\"point\":[" x[0] "," x[1] "," x[2] "]}"
        print "{\"ray\":{\"origin\":[" x[0] "," x[1] "," x[2] "],\"direction\":[" x[3] "," x[4] "," x[5] "]}}"
        print "{\"segment\":[[" x[0] "," x[1] "," x[2] "],[" x[3] "," x[4] "," x[5] "]],\"radius\":0.3}"
    }
}' >"$dir/many"
"$nook" query "$torus" <"$dir/many" >"$dir/uncut" 2>"$dir/err" || no "many questions: $(cat "$dir/err")"
[ "$(wc -l <"$dir/uncut")" -eq 120 ] && ok || no "$(wc -l <"$dir/uncut") answers for 120"
: >"$dir/all"
for budget in 0 1 2 4 8 12 16 20 24 32 64 128 256 512 100000; do
    "$nook" query --budget $budget "$torus" <"$dir/many" >"$dir/cut" 2>"$dir/err" || no "budget $budget: $(cat "$dir/err")"
    grep '"complete":false' "$dir/cut" >>"$dir/all"
    wrong=$(paste -d '|' "$dir/uncut" "$dir/cut" | awk -F'|' '
        function value(text, key) {
            if (!match(text, "\"" key "\":[^,}]*")) return "none"
            return substr(text, RSTART + length(key) + 3, RLENGTH - length(key) - 3)
        }
        function differs(key) { v = value($2, key); return v != "null" && v != value($1, key) }
        $2 !~ /"complete":false/ { if ($1 != $2) print NR ": not the same: " $0; next }
        $1 ~ /"distance"/ {
            d = value($1, "distance") + 0
            if (value($2, "distance_min") + 0 > d || d > value($2, "distance_max") + 0) print NR ": " $0
            if (value($2, "distance") != "none") print NR ": complete or not? " $0
        }
        $1 ~ /"hit":true/ {
            t = value($1, "t") + 0
            if (value($2, "t_min") + 0 > t) print NR ": " $0
            if (value($2, "hit") == "true" && value($2, "t") + 0 < t) print NR ": " $0
        }
        differs("side") || differs("hit") || differs("touches") { print NR ": " $0 }')
    [ -z "$wrong" ] && ok || no "budget $budget: $(printf '%s\n' "$wrong" | head -n 3)"
done
for kind in 'a side and no distance' 'neither side nor distance' 'no hit so far' 'a hit so far' 'a capsule'; do
    grep -q -e "$(form_of "$kind")" "$dir/all" && ok || no "$kind: no answer is like that"
    grep -v -e "$(form_of "$kind")" "$dir/all" >"$dir/rest"
    mv "$dir/rest" "$dir/all"
done
[ -s "$dir/all" ] && no "answers of no known form: $(head -n 3 "$dir/all")" || ok
cmp -s "$dir/uncut" "$dir/cut" && ok || no 'a budget of 100000 cuts nothing'
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
