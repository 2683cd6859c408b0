#!/usr/bin/env python3
"""What the guards of the survey cost: the checks of every index it reads, of its marks, and of its steps, without
which a flipped bit sends a search or a walk out of its tables or round for ever. They are taken out of a copy; both
survey the same mesh on the emulated Cortex-M4F, which counts instructions. Fails above 25 percent.

usage: guards.py CROSS MACHINE CFLAGS... (compiles with the flags given)"""
import pathlib, re, subprocess, sys

GUARDS = [  # in src/table/nook_survey.c; what is left is the naive search of a trusted table
    ('return o < 3u * s->view.nt ? o : c;', 'return o;'),
    ('if (o >= 3u * s->view.nt) return false;', ''),
    ('if (k == 0 || k == 7u) return false;', ''),
    ('if (v >= s->view.nv || s->shells->stamp[v] == k) continue;', 'if (s->shells->stamp[v] == k) continue;'),
    ('if (s->v >= s->view.nv) return false;', ''),
    ('if (at_v == NOOK_NONE || nook_bit(s->marks.Mt, at_v)) return false;', ''),
    ('if (at_v == NOOK_NONE) return false;', ''),
    ('if (nook_bit(s->marks.Mt, x)) return false;', ''),
    ('if (s->hops-- == 0 || !hop(s)) s->phase = FAILED;', '(void)hop(s);'),
]
cross, machine, *flags = sys.argv[1:]
folder = pathlib.Path('build/guards')
folder.mkdir(parents=True, exist_ok=True)
text = pathlib.Path('src/table/nook_survey.c').read_text()
for guard, naive in GUARDS:
    if text.count(guard) != 1:
        sys.exit(f'guards.py does not know src/table/nook_survey.c any more: {guard}')
    text = text.replace(guard, naive)
naive = folder / 'naive_survey.c'
naive.write_text(text)
survey = pathlib.Path('src/table/nook_survey.c')
others = sorted(str(p) for p in pathlib.Path('src').glob('*/*.c') if p != survey)


def instructions(name, source):
    elf = folder / f'{name}.elf'
    subprocess.run([cross + 'gcc', *flags, '-DONLY_SURVEY', 'tests/bench/costs.c', 'tests/check.c', str(source), *others,
                    'port/semihosting/nook_port.c', 'boards/cortex_m/startup.c', '-nostartfiles', '--specs=nano.specs',
                    '-Lboards/cortex_m', '-T', f'boards/{machine}/board.ld', '-Wl,--gc-sections', '-o', str(elf)], check=True)
    said = subprocess.run(['qemu-system-arm', '-M', machine, '-icount', 'shift=6,sleep=off', '-display', 'none', '-monitor',
                           'none', '-serial', 'null', '-chardev', 'stdio,id=sh', '-semihosting-config',
                           'enable=on,target=native,chardev=sh', '-kernel', str(elf)],
                          check=True, capture_output=True, text=True, timeout=100).stdout
    return int(re.search(r'survey (\d+)', said).group(1))


guarded, trusting = instructions('guarded', survey), instructions('naive', naive)
more = 100 * (guarded - trusting) / trusting
print(f'survey of a torus, instructions a triangle on {machine}: {trusting} without guards, {guarded} with: {more:+.1f} %')
good = more <= 25
print(f'{int(good)} passed, {int(not good)} failed, 0 skipped')
sys.exit(not good)
