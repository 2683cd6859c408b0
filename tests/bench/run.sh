#!/bin/sh
# run.sh -- nook_link and Draco's CornerTable on the same three meshes, one after the other in turn:
# nanoseconds a triangle, best of 20; with valgrind also instructions. Then the exact signs on the boards.
set -e
dir=build/bench
mkdir -p $dir
cc -O2 -g -std=c99 -ffp-contract=off -fno-math-errno -Isrc tests/bench/link_bench.c src/*/*.c -o $dir/link16
cc -O2 -g -std=c99 -ffp-contract=off -fno-math-errno -DNOOK_INDEX_BITS=32 -Isrc tests/bench/link_bench.c src/*/*.c -o $dir/link32
c++ -O2 -g tests/bench/draco_bench.cc -ldraco -o $dir/draco
count() { # function, command: instructions a triangle
    command -v valgrind >/dev/null || return 0
    function=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect="$function" "$@" 2>&1 >/dev/null |
        awk '/Collected/ {printf "    %.0f instructions a triangle\n", $NF / 20480}'
}
for mesh in ordered shuffled hub; do
    $dir/link16 $mesh write >$dir/$mesh.obj
    for bits in 16 32; do
        echo "nook, $bits-bit indices, $($dir/link$bits $mesh 20)"
        count nook_link $dir/link$bits $mesh 1
    done
    $dir/draco $dir/$mesh.obj "$([ $mesh = hub ] && echo 3 || echo 20)"
    count 'link_faces*' $dir/draco $dir/$mesh.obj 1
done

# Instructions of the exact signs, by kind of case, on the emulated boards.
if command -v arm-none-eabi-gcc >/dev/null && command -v qemu-system-arm >/dev/null; then
    on_board() { # board, length of a tick in tenths of a nanosecond, flags
        board=$1 tick=$2
        shift 2
        arm-none-eabi-gcc "$@" -mthumb -std=c99 -O2 -ffp-contract=off -fno-math-errno -ffunction-sections -DTICK="$tick" \
            -Isrc -Iport -Itests tests/bench/exact.c tests/big.c tests/check.c src/core/*.c src/exact/*.c \
            port/semihosting/nook_port.c boards/cortex_m/startup.c -nostartfiles --specs=nano.specs -Lboards/cortex_m \
            -T boards/"$board"/board.ld -Wl,--gc-sections -o $dir/exact.elf
        echo "$board"
        timeout 100 qemu-system-arm -M "$board" -icount shift=6,sleep=off -display none -monitor none -serial null \
            -chardev stdio,id=sh -semihosting-config enable=on,target=native,chardev=sh -kernel $dir/exact.elf
    }
    on_board microbit 625 -mcpu=cortex-m0
    on_board mps2-an386 400 -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16
fi
