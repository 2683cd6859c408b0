#!/bin/sh
# symbols.sh -- what objects export and need. usage: symbols.sh NM OBJECT...
# Exports begin with nook_. Needed may be only each other, the four functions of memory that a compiler
# asks of every platform, and its helpers for integers and single floats: a list of what is allowed, so
# that malloc, stdio, errno, sqrtf and helpers for double fail by not being on it. No data changes.
nm=$1
shift
bad=0
complain() { [ -z "$2" ] || { echo "$nm: $1: $2"; bad=1; }; }
exports=$($nm -g --defined-only "$@" | awk 'NF == 3 {print $3}' | sort -u)
needs=$($nm -u "$@" | awk 'NF == 2 {print $2}' | sort -u)
[ -n "$exports" ] || complain "no exports" "are these objects?"
complain "exported without nook_" "$(echo "$exports" | grep -v '^nook_' | tr '\n' ' ')"
complain "data that changes" "$($nm "$@" | awk '$2 ~ /^[dDbBC]$/ {print $3}' | tr '\n' ' ')"
# The same by sizes, for data that has no name.
complain "bytes of .data or .bss" "$("${nm%nm}size" "$@" | awk 'NR > 1 && $2 + $3 > 0 {print $6}' | tr '\n' ' ')"
memory='mem(cpy|set|move|cmp)|__aeabi_mem(cpy|set|clr|move)[48]?'
floats='__aeabi_(fr?sub|fadd|fmul|fdiv|fcmp(eq|lt|le|ge|gt|un)|f2u?iz|u?i2f|f2u?lz|u?l2f)'
integers='__aeabi_(u?idiv(mod)?|u?ldivmod|lmul|llsl|llsr|lasr|lcmp|ulcmp)|__gnu_thumb1_case_[a-z]+|__c[lt]zsi2'
complain "needed" "$(echo "$needs" | grep -vxE "|nook_.*|_GLOBAL_OFFSET_TABLE_|$memory|$floats|$integers" | tr '\n' ' ')"
missing=$(echo "$needs" | grep '^nook_' | while read -r s; do echo "$exports" | grep -qx "$s" || echo "$s"; done | tr '\n' ' ')
complain "declared but nowhere" "$missing"
[ $bad -ne 0 ] || echo "$nm: $(echo "$exports" | wc -l) exports, all nook_; helpers: $(echo "$needs" | grep -v '^nook_' | tr '\n' ' ')"
exit $bad
