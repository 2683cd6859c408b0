#!/bin/sh
# sum.sh -- run commands that end with "N passed, N failed, N skipped", and add up those lines.
# usage: sum.sh REQUIRE COMMAND...   "skip: why" counts as skipped, or as failed where REQUIRE is 1.
# A command that ends with no such line, or with a status its line does not explain, counts as failed;
# so does a run of nothing at all.
require=$1
shift
passed=0 failed=0 skipped=0
for command in "$@"; do
    case $command in
    skip:*)
        echo "SKIPPED:${command#skip:}"
        if [ "$require" = 1 ]; then failed=$((failed + 1)); else skipped=$((skipped + 1)); fi
        continue ;;
    esac
    echo "== $command"
    output=$(sh -c "$command" 2>&1 </dev/null)
    status=$?
    [ -z "$output" ] || printf '%s\n' "$output"
    line=$(printf '%s\n' "$output" | sed -n 's/^\([0-9]*\) passed, \([0-9]*\) failed, \([0-9]*\) skipped$/\1 \2 \3/p' | tail -n 1)
    if [ -z "$line" ]; then
        echo "FAILED: no closing line, status $status"
        failed=$((failed + 1))
        continue
    fi
    set -- $line
    passed=$((passed + $1)) failed=$((failed + $2)) skipped=$((skipped + $3))
    if [ $status -ne 0 ] && [ "$2" = 0 ]; then
        echo "FAILED: status $status"
        failed=$((failed + 1))
    fi
done
echo "$passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ] && [ $((passed + skipped)) -gt 0 ]
