#!/bin/sh
# tools.sh -- what the boards, lint and reports need beyond a C compiler and make.
packages="gcc-arm-none-eabi libnewlib-arm-none-eabi qemu-system-arm clang clang-tidy clang-format cppcheck g++ python3"
echo "On Debian: apt-get install --no-install-recommends $packages"
command -v apt-get >/dev/null && [ "$(id -u)" = 0 ] || exit 0
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $packages
