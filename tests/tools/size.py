#!/usr/bin/env python3
"""Bytes of code and data of each object. usage: size.py CROSS NAME FOLDER"""
import pathlib, subprocess, sys

cross, name, folder = sys.argv[1:]
objects = [f'{folder}/{p.with_suffix(".o")}' for p in sorted(pathlib.Path('src').glob('*/*.c'))]
rows = [line.split() for line in subprocess.check_output([cross + 'size', *objects], text=True).splitlines()[1:]]
print(f'{name}: bytes of text, data, bss')
for text, data, bss, _, _, path in rows:
    print(f'  {pathlib.Path(path).stem:16}{text:>6}{data:>6}{bss:>6}')
print(f'  {"all":16}' + ''.join(f'{sum(int(r[i]) for r in rows):6}' for i in range(3)))
