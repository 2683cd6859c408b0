#!/usr/bin/env python3
"""Hold what the library costs against the table tests/costs.txt: code bytes of each object, worst stack of each
public function, instructions counted in the emulator. A cost above its line by more than 3 percent fails, and so
does one without a line or a line without a cost. With another compiler than the table's nothing is compared.

usage: costs.py [--update] --cross PREFIX (--cores NAME:FLAGS)... --boards ELF:MACHINE..."""
import argparse, pathlib, re, subprocess, sys

TABLE = pathlib.Path('tests/costs.txt')
ap = argparse.ArgumentParser()
ap.add_argument('--update', action='store_true')
ap.add_argument('--cross')
ap.add_argument('--cores', action='append')
ap.add_argument('--boards', nargs='*')
opts = ap.parse_args()


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True, timeout=300).stdout


def measure():
    costs = {}
    for name, flags in (core.split(':', 1) for core in opts.cores):
        objects = [f'build/{name}/{p.with_suffix(".o")}' for p in sorted(pathlib.Path('src').glob('*/*.c'))]
        for line in run(opts.cross + 'size', *objects).splitlines()[1:]:
            words = line.split()
            costs[name, 'code', pathlib.Path(words[5]).stem] = int(words[0])
        stacks = run(sys.executable, 'tests/tools/stack.py', '--limit', '100000', '--cross', opts.cross, '--name', name,
                     '--objects', f'build/{name}', '--', *flags.split())
        for size, function in re.findall(r'^ +(\d+)  (\w+)$', stacks, re.M):
            costs[name, 'stack', function] = int(size)
    for elf, machine in (board.split(':') for board in opts.boards):
        text = run('qemu-system-arm', '-M', machine, '-icount', 'shift=6,sleep=off', '-display', 'none', '-monitor', 'none',
                   '-serial', 'null', '-chardev', 'stdio,id=sh', '-semihosting-config',
                   'enable=on,target=native,chardev=sh', '-kernel', elf)
        for what, number in re.findall(r'^(\w+) (\d+)$', text, re.M):
            costs[machine, 'instructions', what] = int(number)
    return costs


compiler = run(opts.cross + 'gcc', '--version').splitlines()[0]
costs = measure()
if opts.update:
    TABLE.write_text(f'{compiler}\n' + ''.join(f'{" ".join(key)} {cost}\n' for key, cost in costs.items()))
    print(f'wrote {len(costs)} lines to {TABLE}; read what changed before you commit it')
    sys.exit()
first, *lines = TABLE.read_text().splitlines()
if first != compiler:
    print(f'SKIPPED: the table is of "{first}", this is "{compiler}"')
    print('0 passed, 0 failed, 1 skipped')
    sys.exit(0)
kept = {tuple(words[:3]): int(words[3]) for words in map(str.split, lines)}
bad = []
for key in sorted(kept.keys() | costs.keys()):
    was, now = kept.get(key), costs.get(key)
    if was is None or now is None or now > was * 1.03:
        bad.append(f'{" ".join(key)}: {was} in the table, now {now}')
print('\n'.join(bad))
shrunk = [key for key in kept if key in costs and costs[key] < kept[key] * 0.97]
for key in shrunk:
    print(f'less than the table says, `make costs UPDATE=1` keeps it so: {" ".join(key)}: {kept[key]}, now {costs[key]}')
print(f'{len(kept.keys() | costs.keys()) - len(bad)} passed, {len(bad)} failed, 0 skipped')
sys.exit(bool(bad))
