#!/usr/bin/env python3
"""mutate.py -- do the tests notice when the library is wrong?

Makes small changes to src/**/*.c, one at a time: another comparison, a constant one more or less, && for ||,
a condition turned round, a statement left out, next for previous. Each mutant is compiled (16-bit indices,
-O1) and run against the tests of tests/*.c; it is killed if a test fails, crashes or takes too long. A mutant
that does not compile, or that compiles to the very same code, says nothing and is not counted.

The sources are copied to build/mutants first; src/ is never touched. A sample is repeatable: --seed. The
survivors are printed with place and change; some of them are no faults at all (a < that may as well be !=).

usage: mutate.py [--sample 40] [--seed 1] [--at-least 85] [--only nook_link] [--list] [--killed]
Exit status 1 if less than --at-least percent are killed. The last line is "N passed, N failed, N skipped",
where passed are the killed ones."""
import argparse
import concurrent.futures
import glob
import os
import random
import re
import shutil
import subprocess
import sys
import time

ROOM = "build/mutants"
CC = os.environ.get("CC", "gcc")
FLAGS = "-std=c99 -O1 -w -ffp-contract=off -fno-math-errno -DNOOK_INDEX_BITS=16 -Isrc -Iport -Itests".split()
TESTS = "tests/*.c", "port/posix/nook_port.c"


# ---- what can be changed ---------------------------------------------------------------------------

def blank_out(text):
    """The text with comments, strings, characters and preprocessor lines as blanks, same length."""
    pattern = r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#(?:\\\n|[^\n])*'
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S | re.M)


SWAPS = {
    "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="],
    "&&": ["||"], "||": ["&&"], "+": ["-"], "-": ["+"], "++": ["--"], "--": ["++"], "+=": ["-="],
    "-=": ["+="], "&": ["|"], "|": ["&"], "^": ["|"], "<<": [">>"], ">>": ["<<"], "|=": ["&="], "&=": ["|="],
}
OPERATOR = re.compile(r"->|\+\+|--|<<=|>>=|[-+*/|&^]=|<<|>>|<=|>=|==|!=|&&|\|\||[-+<>&|^]")
SWAPPED_CALLS = {"nook_next": "nook_prev", "nook_prev": "nook_next", "true": "false", "false": "true"}
STATEMENT = re.compile(
    r"^[ \t]*(?!(?:return|break|continue|case|default|for|if|while|do|switch|else|typedef|static|const"
    r"|struct)\b)"
    r"(?:--|\+\+|\*|\(void\))?[a-zA-Z_][^;{}\n]*"
    r"(?:\([^;{}\n]*\)|[-+|&^<>]?=[^;{}\n]*|\+\+|--|[a-zA-Z_\])]);", re.M)
DECLARATION = re.compile(
    r"^[ \t]*(?:const |unsigned )*[a-zA-Z_]\w*[ ]+\**[a-zA-Z_]\w*(?:\[[^\]]*\])?[ ]*(?:=|;|,|\()")


def is_binary(code, start):
    """Whether the operator that begins here has a value to its left."""
    before = code[:start].rstrip()
    if not before or not re.match(r"[\w)\]]", before[-1]):
        return False
    return not re.search(r"\b(?:return|case|sizeof)$", before)


def operator_changes(code):
    for m in OPERATOR.finditer(code):
        op = m.group()
        if op not in SWAPS or (op in "+-&" and not is_binary(code, m.start())):
            continue
        for other in SWAPS[op]:
            yield m.start(), m.end(), other


def constant_changes(code):
    for m in re.finditer(r"(?<![\w.])(0[xX][0-9a-fA-F]+|\d+)([uU]?)(?![\w.])", code):
        value = int(m.group(1), 0) if not re.fullmatch(r"0\d+", m.group(1)) else int(m.group(1), 8)
        yield m.start(), m.end(), f"{value + 1}{m.group(2)}"
        if value > 0:
            yield m.start(), m.end(), f"{value - 1}{m.group(2)}"


TURNED = "not what stood here"


def closing(code, start):
    depth = 0
    for i in range(start, len(code)):
        depth += {"(": 1, ")": -1}.get(code[i], 0)
        if depth == 0:
            return i
    return None


def condition_changes(code):
    for m in re.finditer(r"\b(?:if|while) \(", code):
        end = closing(code, m.end() - 1)
        if end is not None:
            yield m.end(), end, TURNED
    for m in re.finditer(r"!(?!=)", code):
        yield m.start(), m.end(), ""
    for m in re.finditer(r"\? ", code):
        yield m.start(), m.start(), "&& 0 "


def other_changes(code):
    for m in re.finditer(r"\b(?:nook_next|nook_prev|true|false)\b", code):
        yield m.start(), m.end(), SWAPPED_CALLS[m.group()]
    for m in STATEMENT.finditer(code):
        if not DECLARATION.match(m.group()):
            text = m.group()
            start = m.start() + len(text) - len(text.lstrip())
            yield start, m.end(), ";"
    for m in re.finditer(r"\breturn ([^;\n]+);", code):
        if "NOOK_OK" not in m.group(1) and m.group(1) not in ("true", "false"):
            yield m.start(1), m.end(1), f"({m.group(1)}) * 0"
    for m in re.finditer(r"\b(?:break|continue);", code):
        yield m.start(), m.end(), ";"


def mutants_of(path):
    text = open(os.path.join(ROOM, "tree", path)).read()
    code = blank_out(text)
    found = []
    for make in (operator_changes, constant_changes, condition_changes, other_changes):
        for start, end, new in make(code):
            found.append((path, start, end, new if new != TURNED else f"!({text[start:end]})"))
    return sorted(set(found))


# ---- one mutant ------------------------------------------------------------------------------------

def describe(mutant):
    path, start, end, new = mutant
    text = open(os.path.join(ROOM, "tree", path)).read()
    line = text.count("\n", 0, start) + 1
    first = text.rfind("\n", 0, start) + 1
    last = text.find("\n", end)
    before = text[first:last].strip()
    after = (text[first:start] + new + text[end:last]).strip()
    short = lambda s: re.sub(r"\s+", " ", s)[:150]
    return f"{path}:{line}: {short(before)}  ->  {short(after)}"


def run(command, limit=None, **more):
    """True if it ends well within the limit."""
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=limit, **more).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def object_of(source):
    return os.path.join(ROOM, "objects", source.replace("/", "_") + ".o")


def compile_to(source, target):
    """Compile a file against the copied tree."""
    tree = os.path.join(ROOM, "tree")
    flags = [f if not f.startswith("-I") else "-I" + os.path.join(tree, f[2:]) for f in FLAGS]
    return run([CC, *flags, "-c", source, "-o", target])


def code_of(path):
    """Code, data and relocations of an object, without its file's name."""
    dump = subprocess.run(["objdump", "-r", "-s", path], stdout=subprocess.PIPE, check=False)
    return re.sub(rb"^.*file format.*$", b"", dump.stdout, flags=re.M)


def try_mutant(job):
    """'killed', 'survived', 'same' or 'broken'."""
    number, mutant, objects, limit = job
    path, start, end, new = mutant
    place = os.path.join(ROOM, f"mutant{number}")
    text = open(os.path.join(ROOM, "tree", path)).read()
    os.makedirs(place, exist_ok=True)
    source, target, program = (os.path.join(place, n) for n in (os.path.basename(path), "m.o", "tests"))
    open(source, "w").write(text[:start] + new + text[end:])
    try:
        if not compile_to(source, target):
            return "broken"
        original = object_of(path)
        if code_of(target) == code_of(original):
            return "same"
        others = [o for o in objects if o != original]
        if not run([CC, target, *others, "-o", program]):
            return "broken"
        return "survived" if run([program], limit) else "killed"
    finally:
        shutil.rmtree(place, ignore_errors=True)


# ---- all of them -----------------------------------------------------------------------------------

def prepare():
    shutil.rmtree(ROOM, ignore_errors=True)
    tree = os.path.join(ROOM, "tree")
    os.makedirs(os.path.join(ROOM, "objects"))
    for folder in ("src", "port", "tests"):
        left_out = shutil.ignore_patterns("prove", "fuzz", "tools", "bench")
        shutil.copytree(folder, os.path.join(tree, folder), ignore=left_out)
    sources = [os.path.relpath(p, tree) for pattern in ("src/**/*.c", *TESTS)
               for p in sorted(glob.glob(os.path.join(tree, pattern), recursive=True))]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        done = list(pool.map(lambda s: compile_to(os.path.join(tree, s), object_of(s)), sources))
    if not all(done):
        sys.exit("mutate: the library or its tests do not compile: " + sources[done.index(False)])
    program = os.path.join(ROOM, "tests")
    objects = [object_of(s) for s in sources]
    since = time.monotonic()
    if not run([CC, *objects, "-o", program]) or not run([program], 600):
        sys.exit("mutate: the tests fail without any change")
    return sources, objects, time.monotonic() - since


def choose(sources, options):
    all_of_them = []
    for source in sources:
        if source.startswith("src/") and (options.only is None or options.only in source):
            all_of_them += mutants_of(source)
    random.Random(options.seed).shuffle(all_of_them)
    return all_of_them


def report(tally, survivors, options, since):
    counted = tally["killed"] + tally["survived"]
    share = 100.0 * tally["killed"] / counted if counted else 0.0
    for text in survivors:
        print("survived " + text)
    print(f"{counted} mutants: {tally['killed']} killed, {tally['survived']} survived: {share:.1f} % killed, "
          f"{options.at_least} wanted; not counted: {tally['same']} that change nothing, "
          f"{tally['broken']} that do not compile; {time.monotonic() - since:.0f} s")
    bad = share < options.at_least
    print(f"{tally['killed']} passed, {tally['survived'] if bad else 0} failed, 0 skipped")
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--sample", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--at-least", type=float, default=0)
    parser.add_argument("--only", help="part of a file's name")
    parser.add_argument("--list", action="store_true", help="print the sample and stop")
    parser.add_argument("--killed", action="store_true", help="print the killed ones as well")
    options = parser.parse_args()
    since = time.monotonic()
    sources, objects, seconds = prepare()
    mutants = choose(sources, options)
    print(f"{len(mutants)} possible mutants; the tests take {seconds:.1f} s")
    if options.list:
        print("\n".join(describe(m) for m in mutants[:options.sample]))
        return 0
    limit = 5 + 10 * seconds
    tally, survivors = dict.fromkeys(("killed", "survived", "same", "broken"), 0), []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        at = 0
        while at < len(mutants) and tally["killed"] + tally["survived"] < options.sample:
            more = options.sample - tally["killed"] - tally["survived"]
            batch = mutants[at:at + more]
            jobs = [(at + i, m, objects, limit) for i, m in enumerate(batch)]
            for mutant, outcome in zip(batch, pool.map(try_mutant, jobs)):
                tally[outcome] += 1
                if outcome == "survived":
                    survivors.append(describe(mutant))
                elif outcome == "killed" and options.killed:
                    print("killed   " + describe(mutant), flush=True)
            at += len(batch)
    return report(tally, survivors, options, since)


if __name__ == "__main__":
    sys.exit(main())
