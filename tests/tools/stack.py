#!/usr/bin/env python3
"""Worst-case stack of every public function, library helpers included; recursion fails.

Own functions: gcc's -fstack-usage and -fcallgraph-info, one .ci file an object. Helpers of the compiler
and of libc have none, so the first instructions of each are read from the disassembly of libgcc and
libc: pushes and what is taken off sp, and whom they call. Calls through a pointer are listed: the caller's own
nook_finder, whose stack is not counted, and what edits ask of a nook_guard, counted apart."""
import argparse, collections, pathlib, re, subprocess, sys

ap = argparse.ArgumentParser()
ap.add_argument('--limit', type=int)
ap.add_argument('--cross')
ap.add_argument('--name')
ap.add_argument('--objects')
ap.add_argument('flags', nargs='*')
opts = ap.parse_args()

frame, calls, indirect, guarded = {}, collections.defaultdict(set), set(), set()


def short(title):
    return title.rsplit(':', 1)[-1]


for path in (pathlib.Path(opts.objects, p).with_suffix('.ci') for p in sorted(pathlib.Path('src').glob('*/*.c'))):
    own = {}  # statics of the same name in two files stay apart
    text = path.read_text()
    for title, label in re.findall(r'node: \{ title: "([^"]*)" label: "([^"]*)"', text):
        used = re.search(r'(\d+) bytes \((static|dynamic[^)]*)\)', label)
        own[title] = title if used and ':' in title else short(title)
        if used:
            if used.group(2) != 'static':
                sys.exit(f'{title}: stack is not static')
            frame[own[title]] = int(used.group(1))
    for source, target in re.findall(r'edge: \{ sourcename: "([^"]*)" targetname: "([^"]*)"', text):
        if target == '__indirect_call':
            indirect.add(short(source))
            if re.match(r'src/edit/nook_(local|sew|fill)\.c:', source):
                guarded.add(source)
        else:
            calls[own[source]].add(own.get(target, short(target)))


def helper_frames():
    gcc = opts.cross + 'gcc'
    ask = lambda *a: subprocess.check_output([gcc, *opts.flags, *a], text=True).strip()
    alias = {}
    for archive in (ask('-print-libgcc-file-name'), ask('--specs=nano.specs', '-print-file-name=libc_nano.a')):
        listing = subprocess.run([opts.cross + 'objdump', '-dr', archive], capture_output=True, text=True).stdout
        now = None
        for line in listing.splitlines():
            begin = re.match(r'^[0-9a-f]+ <([^>]+)>:$', line)
            if begin:
                now = begin.group(1)
                frame.setdefault(now, 0)
                grown = frame[now] == 0
                continue
            if not now or not grown:
                continue
            push = re.search(r'\tv?push\t\{([^}]*)\}', line) or re.search(r'\tstmdb\tsp!, \{([^}]*)\}', line)
            if push:
                for part in push.group(1).split(','):
                    ends = re.findall(r'\d+', part) if '-' in part else []
                    frame[now] += 4 * (int(ends[1]) - int(ends[0]) + 1 if ends else 1)
            down = re.search(r'\tsub(?:w|\.w)?\tsp, (?:sp, )?#(\d+)', line) or re.search(r'\[sp, #-(\d+)\]!', line)
            if down:
                frame[now] += int(down.group(1))
            target = re.search(r'R_ARM_(?:THM_)?(?:CALL|JUMP\d+|XPC22)\s+(\S+)', line) or re.search(r'\tblx?\t[0-9a-f]+ <([^>+]+)', line)
            if target and target.group(1) != now:
                calls[now].add(target.group(1))
        # One address may have two names, of which the disassembly shows one.
        places = collections.defaultdict(list)
        for line in subprocess.run([opts.cross + 'nm', '-A', archive], capture_output=True, text=True).stdout.splitlines():
            member, _, rest = line.rpartition(':')
            words = rest.split()
            if len(words) == 3 and words[1] in 'TtWw':
                places[member, words[0]].append(words[2])
        for names in places.values():
            shown = [n for n in names if n in frame]
            for name in names if shown else ():
                if name not in frame:
                    alias[name] = shown[0]
    for name, shown in alias.items():
        if name not in frame:
            frame[name], calls[name] = 0, {shown}


helper_frames()
worst, on_path, unknown = {}, [], set()


def depth(name):
    if name in worst:
        return worst[name]
    if name in on_path:
        sys.exit('recursion: ' + ' -> '.join(on_path[on_path.index(name):] + [name]))
    if name not in frame:
        unknown.add(name)
        return 0
    on_path.append(name)
    worst[name] = frame[name] + max((depth(c) for c in sorted(calls[name])), default=0)
    on_path.pop()
    return worst[name]


public = sorted((n for n in frame if n.startswith('nook_')), key=lambda n: (-depth(n), n))
print(f'{opts.name}: worst-case stack in bytes, helpers included')
for name in public:
    print(f'  {depth(name):4}  {name}')
alone = dict(worst)
worst.clear()
for source in guarded:
    calls[source].add('nook_guard_look')
for name in sorted(public, key=lambda n: (-depth(n), n)):
    if depth(name) != alone[name]:
        print(f'  {depth(name):4}  {name}_with_a_guard')
worst = alone
print(f'  calls through a pointer (a nook_finder): {", ".join(sorted(indirect)) or "none"}')
if unknown:
    sys.exit(f'nothing is known of: {", ".join(sorted(unknown))}')
if not public or depth(public[0]) > opts.limit:
    sys.exit(f'above {opts.limit} bytes')
