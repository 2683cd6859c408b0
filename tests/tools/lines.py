#!/usr/bin/env python3
"""Code lines (no comments, no blanks) of each room against the ceilings of the design."""
import pathlib, re, sys

CEILINGS = {'core': 500, 'table': 900, 'walk': 500, 'edit': 1300, 'query': 1400, 'pack': 900, 'robot': 400}


def code_lines(path):
    text = re.sub(r'/\*.*?\*/', '', path.read_text(), flags=re.S)
    return sum(1 for line in text.splitlines() if line.strip())


total = 0
for room, ceiling in CEILINGS.items():
    files = sorted(pathlib.Path('src', room).glob('*.[ch]'))
    if not files:
        continue
    lines = sum(map(code_lines, files))
    total += lines
    print(f'{room:8}{lines:6} code lines, ceiling {ceiling}{"   PAST IT" if lines > ceiling else ""}')
    print('        ' + ', '.join(f'{f.name.removeprefix("nook_")} {code_lines(f)}' for f in files))
print(f'total   {total:6} code lines')
