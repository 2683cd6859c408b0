#!/usr/bin/env python3
"""Branch coverage of src/ by the tests; fails below 100 %.

usage: coverage.py [BITS...]    index widths, 16 and 32 unless given; CC and GCOV from the environment

Library and tests are built once a width into build/coverageBITS, with gcc (9 or newer) and no tool beyond
its gcov, and run on this machine; the 16-bit build is that of a core without FPU, one lane wide (NOOK_LANES),
the 32-bit build has both as this machine has. At -O0 every condition is a branch with two ways out, and a
switch has a way to each of its targets. A way counts as taken if any translation unit of any width took it,
so one user of a header's inline function is enough to cover it; a way is known by its file, its line and its
position among the ways of that line. What nobody calls is kept in the objects, since it must be covered too.
Of the tests, only what they inline from src/ is measured.

Where decisions.py finds no fault, all of this is MC/DC (its head says why). What gcc makes one instruction
of even at -O0 has no branch to take: a < b ? a : b is a minimum, x < 0 ? -x : x an absolute value.

The last line is the closing line of all our tests: each run is one check, and each file of src/."""
import collections, glob, itertools, json, os, pathlib, subprocess, sys

CC, GCOV = os.environ.get('CC', 'gcc'), os.environ.get('GCOV', 'gcov')
FLAGS = ('-std=c99 -O0 -g -ffp-contract=off -Isrc -Iport -Itests --coverage -fprofile-filter-files=src/.*'
         ' -fkeep-inline-functions -fkeep-static-functions').split()
SOURCES = sorted(glob.glob('src/*/*.c') + glob.glob('tests/*.c')) + ['port/posix/nook_port.c']


def start(bits):
    """Build and run in the background: the widths share the cores."""
    folder = pathlib.Path(f'build/coverage{bits}')
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    elf = f'{folder}/tests.elf'
    width = [f'-DNOOK_INDEX_BITS={bits}', f'-DNOOK_HAS_FPU={int(bits != "16")}']
    width += ['-DNOOK_LANES=1'] if bits == '16' else []
    command = ['sh', '-c', '"$@" && exec "$0"', elf, CC, *FLAGS, *width, *SOURCES, '-o', elf]
    return folder, subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


def lines_of(folder):
    """For each line of each unit: file, line, how often it ran, how often each of its ways was taken."""
    data = sorted(map(str, folder.glob('*.gcda')))
    if not data:
        return
    for unit in subprocess.check_output([GCOV, '-t', '-j', '-b', '-c', *data], text=True).splitlines():
        for file in json.loads(unit)['files']:
            runs, ways = collections.Counter(), collections.defaultdict(list)
            for line in file['lines']: # once for each function that stands on it
                runs[line['line_number']] += line['count']
                ways[line['line_number']] += [way['count'] for way in line['branches']]
            for number in runs:
                yield os.path.relpath(file['file']), number, runs[number], ways[number]


passed = failed = 0
files = collections.defaultdict(dict) # file, then line: how often it ran, and its ways
for folder, run in [start(bits) for bits in sys.argv[1:] or ('16', '32')]:
    output, _ = run.communicate()
    if run.returncode == 0:
        passed += 1
    else:
        failed += 1
        print(f'{output}FAILED: {folder}/tests.elf does not build, or does not pass')
    for path, line, runs, ways in lines_of(folder):
        known_runs, known = files[path].get(line, (0, []))
        added = [a + b for a, b in itertools.zip_longest(known, ways, fillvalue=0)]
        files[path][line] = known_runs + runs, added

print(f'{"":32}{"lines run":>14}{"ways taken":>14}')
total = [0, 0, 0, 0]
for path in sorted(map(str, pathlib.Path('src').rglob('*.[ch]'))):
    lines = files[path]
    ways = [count for _, counts in lines.values() for count in counts]
    counts = [sum(runs != 0 for runs, _ in lines.values()), len(lines), sum(map(bool, ways)), len(ways)]
    total = [a + b for a, b in zip(total, counts)]
    good = counts[2] == counts[3] and (lines != {} or path.endswith('.h'))
    passed, failed = passed + good, failed + (not good)
    print('  {:30}{:7} /{:5}{:7} /{:5}'.format(path, *counts))
    text = pathlib.Path(path).read_text().splitlines()
    for line, (_, counts) in sorted(lines.items()):
        never = ', '.join(str(i) for i, count in enumerate(counts, 1) if count == 0)
        if never:
            print(f'{path}:{line}: never took {never} of {len(counts)}: {text[line - 1].strip()}')
print('  {:30}{:7} /{:5}{:7} /{:5}'.format('all', *total))
print(f'{passed} passed, {failed} failed, 0 skipped')
sys.exit(failed != 0)
