#!/bin/sh
# sum.sh -- run commands that end with "N passed, N failed, N skipped", two at a time, and add up those lines.
# usage: sum.sh REQUIRE COMMAND...   "skip: why" counts as skipped, or as failed where REQUIRE is 1.
# A command that ends with no such line, or with a status its line does not explain, counts as failed;
# so does a run of nothing at all.
require=$1
shift
run() { # number: its command, unless that is none
    case $(cat "$1.command") in
    skip:*) return ;;
    esac
    sh "$1.command" >"$1" 2>&1 </dev/null
    echo $? >"$1.status"
}
if [ "$require" = run ]; then
    run "$1"
    exit 0
fi
passed=0 failed=0 skipped=0
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT

tell() { # number, command
    case $2 in
    skip:*)
        echo "SKIPPED:${2#skip:}"
        if [ "$require" = 1 ]; then failed=$((failed + 1)); else skipped=$((skipped + 1)); fi
        return ;;
    esac
    echo "== $2"
    cat "$folder/$1"
    status=$(cat "$folder/$1.status")
    line=$(sed -n 's/^\([0-9]*\) passed, \([0-9]*\) failed, \([0-9]*\) skipped$/\1 \2 \3/p' "$folder/$1" | tail -n 1)
    if [ -z "$line" ]; then
        echo "FAILED: no closing line, status $status"
        failed=$((failed + 1))
        return
    fi
    # shellcheck disable=SC2086 # three numbers
    set -- $line
    passed=$((passed + $1)) failed=$((failed + $2)) skipped=$((skipped + $3))
    if [ "$status" -ne 0 ] && [ "$2" = 0 ]; then
        echo "FAILED: status $status"
        failed=$((failed + 1))
    fi
}

n=0
for command in "$@"; do
    n=$((n + 1))
    printf '%s\n' "$command" >"$folder/$n.command"
    echo "$folder/$n"
done | xargs -P 2 -n 1 sh "$0" run
n=0
for command in "$@"; do
    n=$((n + 1))
    tell $n "$command"
done
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
