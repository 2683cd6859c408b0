# host.sh -- what the scripts of tests/host begin with: `. tests/tools/host.sh`, from the top of the tree. NOOK names the program.
nook=${NOOK:-build/nook}
dir=$(mktemp -d) || exit 1
trap 'rm -rf "$dir"' EXIT
passed=0 failed=0 skipped=0

ok() { passed=$((passed + 1)); }
no() { failed=$((failed + 1)); echo "FAILED: $*"; }

# expect NAME STATUS PATTERN COMMAND... : its exit status, and a pattern in what it prints on either output
expect() {
    name=$1 status=$2 pattern=$3
    shift 3
    said=$("$@" 2>&1 </dev/null)
    got=$?
    if [ $got -ne "$status" ]; then no "$name: exit $got instead of $status: $said"
    elif ! printf '%s\n' "$said" | grep -q -e "$pattern"; then no "$name: no '$pattern' in: $said"
    else ok; fi
}
