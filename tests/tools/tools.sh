#!/bin/sh
# tools.sh -- what boards, lint and reports need beyond a C compiler and make: says it, and as root
# on Debian installs what is missing. The one list of packages; continuous integration uses it too.
packages="gcc g++ make python3 clang clang-tidy clang-format cppcheck gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm"
echo "On Debian: apt-get install --no-install-recommends $packages libclang-rt-NN-dev (NN: clang's version)"
echo "For bench, where each may be missing: libdraco-dev libembree-dev libbullet-dev libode-dev libfcl-dev libcgal-dev"
if ! command -v apt-get >/dev/null || [ "$(id -u)" != 0 ]; then
    echo "Not root on Debian: nothing is installed."
    exit 0
fi
export DEBIAN_FRONTEND=noninteractive
install() { # nothing is fetched where all of it is here
    dpkg -s "$@" >/dev/null 2>&1 || { apt-get update -qq && apt-get install -y -qq --no-install-recommends "$@"; }
}
# The runtime of clang's sanitizers is named after clang's version, which is known once clang is here.
install $packages && install "libclang-rt-$(clang -dumpversion | cut -d. -f1)-dev" && echo "All of it is here."
