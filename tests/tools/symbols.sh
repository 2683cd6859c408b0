#!/bin/sh
# symbols.sh -- what objects export and need. usage: symbols.sh NM OBJECT...
# Exports begin with nook_; needed are only each other, memcpy and its kin, and the compiler's helpers
# for integers and single floats; there is no data that changes.
nm=$1
shift
bad=0
complain() { [ -z "$2" ] || { echo "$nm: $1: $2"; bad=1; }; }
exports=$($nm -g --defined-only "$@" | awk 'NF == 3 {print $3}' | sort -u)
needs=$($nm -u "$@" | awk 'NF == 2 {print $2}' | sort -u)
complain "exported without nook_" "$(echo "$exports" | grep -v '^nook_' | tr '\n' ' ')"
complain "data that changes" "$($nm "$@" | awk '$2 ~ /^[dDbBC]$/ {print $3}' | tr '\n' ' ')"
helpers='mem(cpy|set|move|cmp)|strlen|_GLOBAL_OFFSET_TABLE_|__aeabi_(f[a-z]+|[u]?idiv(mod)?|lmul|llsl|llsr|lasr|uldivmod|ldivmod|ui2f|i2f|ul2f|l2f|mem(cpy|set|clr|move)[48]?)|__gnu_thumb1_case_[a-z]+|__clzsi2'
complain "needed" "$(echo "$needs" | grep -vxE "nook_.*|$helpers" | tr '\n' ' ')"
missing=$(echo "$needs" | grep '^nook_' | while read -r s; do echo "$exports" | grep -qx "$s" || echo "$s"; done | tr '\n' ' ')
complain "declared but nowhere" "$missing"
[ $bad -ne 0 ] || echo "$nm: $(echo "$exports" | wc -l) exports, all nook_; helpers: $(echo "$needs" | grep -v '^nook_' | tr '\n' ' ')"
exit $bad
