#!/usr/bin/env python3
"""Every decision of src/ must be a tree; then 100 % of coverage.py is MC/DC.

usage: decisions.py [FILE...]    all of src/ unless given

A decision is what stands in if, while, for, do-while or before a ?, and any other expression of && and ||.
Compiled with short circuits it is a graph: each condition has a way out for true and one for false, to
another condition or to an outcome. If every condition but the first is entered from one place only, the graph
is a tree: a single path leads to each way out of each condition, so whoever takes all ways has, for every
condition, two runs that part at this condition and end differently, which is what MC/DC asks for (AdaCore's
Couverture project: for such decisions, object branch coverage implies MC/DC).

In a && b, b is entered wherever a comes out true, so a must come out true at one place: a && b && c, and
a && (b || c), but not (a || b) && c, where c is entered from a and from b. For || the same with false.

No compiler is needed: comments, strings and directives are blanked, brackets nested, and what is left is
split at ?:, ||, && and !, in this order. Each decision is one check of the closing line."""
import pathlib, re, sys

TOKEN = re.compile(r'[A-Za-z_]\w*|\.?\d[\w.]*|&&|\|\||->|\+\+|--|<<=?|>>=?|[-+*/%&|^=!<>]=|.')
ASSIGN = {'=', '+=', '-=', '*=', '/=', '%=', '&=', '|=', '^=', '<<=', '>>='}
CLOSING = {'(': ')', '[': ']', '{': '}'}


def blank(match):
    return re.sub(r'[^\n]', ' ', match.group())


def nested(text):
    """The tokens as (text, line), and what stands in brackets as (bracket, line, list of tokens)."""
    text = re.sub(r'/\*.*?\*/', blank, text, flags=re.S)
    text = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])*\'', lambda m: '0' + ' ' * (len(m.group()) - 1), text)
    # The value of a macro is looked at; other directives are not.
    text = re.sub(r'^[ \t]*#[ \t]*define\b[ \t]*\w+(\([^)]*\))?', blank, text, flags=re.M)
    text = re.sub(r'^[ \t]*#(.*\\\n)*.*', blank, text, flags=re.M).replace('\\\n', ' \n')
    open_lists = [[]]
    for number, line in enumerate(text.split('\n'), 1):
        for token in TOKEN.findall(line):
            if token.isspace():
                continue
            if token in CLOSING:
                group = (token, number, [])
                open_lists[-1].append(group)
                open_lists.append(group[2])
            elif token in CLOSING.values():
                open_lists.pop()
            else:
                open_lists[-1].append((token, number))
    assert len(open_lists) == 1, 'brackets do not match'
    return open_lists[0]


def split(tokens, separators):
    parts = [[]]
    for token in tokens:
        if token[0] in separators:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


class Decisions(list):
    """(line, how many conditions, whether it is a tree) of each decision of a file."""

    def __init__(self, text):
        super().__init__()
        self.statements(nested(text))

    def statements(self, tokens):
        part = []
        for i, token in enumerate(tokens):
            before = tokens[i - 1][0] if i else ''
            if token[0] == '(' and before in ('if', 'while'):
                self.decision(token[2])
            elif token[0] == '(' and before == 'for':
                first, middle, last = split(token[2], ';')
                self.value(first)
                self.decision(middle)
                self.value(last)
            elif token[0] in ('{', ';', 'return', 'else', 'do', 'if', 'while', 'for', 'case', 'default'):
                self.value(part)
                part = []
                if token[0] == '{':
                    self.statements(token[2])
            elif token[0] == ':' and '?' not in [t[0] for t in part]: # of a label
                part = []
            else:
                part.append(token)
        self.value(part)

    def value(self, tokens):
        """Not a decision by itself, but one if && or || is its last operation."""
        parts = split(tokens, ASSIGN | {','})
        if len(parts) > 1:
            for part in parts:
                self.value(part)
            return
        names = [t[0] for t in tokens]
        if '?' in names:
            condition, yes, no = conditional(tokens)
            self.decision(condition)
            self.value(yes)
            self.value(no)
        elif names[:1] == ['('] and stripped(tokens) is not None:
            self.value(stripped(tokens))
        elif '&&' in names or '||' in names or stripped(tokens) is not None:
            self.decision(tokens, 2)
        else:
            self.atom(tokens)

    def atom(self, tokens):
        for token in tokens:
            if token[0] == '{':
                self.statements(token[2])
            elif len(token) == 3:
                self.value(token[2])

    def decision(self, tokens, least=1):
        if not tokens:
            return # for (;;)
        place = len(self)
        line = tokens[0][1]
        conditions, _, _, tree = self.graph(tokens)
        if conditions >= least:
            self.insert(place, (line, conditions, tree))

    def graph(self, tokens):
        """How many conditions; in how many places it comes out true, and false; whether it is a tree."""
        names = [t[0] for t in tokens]
        inner = stripped(tokens)
        if '?' in names:
            condition, yes, no = map(self.graph, conditional(tokens))
            return (condition[0] + yes[0] + no[0], yes[1] + no[1], yes[2] + no[2],
                    condition[1] == condition[2] == 1 and condition[3] and yes[3] and no[3])
        for operator, way, other in (('||', 2, 1), ('&&', 1, 2)):
            if operator in names:
                parts = [self.graph(part) for part in split(tokens, operator)]
                outs = [0, parts[-1][1], parts[-1][2]]
                outs[other] = sum(part[other] for part in parts)
                return (sum(part[0] for part in parts), outs[1], outs[2],
                        all(part[way] == 1 for part in parts[:-1]) and all(part[3] for part in parts))
        if names[0] == '!' and inner is not None:
            conditions, true, false, tree = self.graph(tokens[1:])
            return conditions, false, true, tree
        if inner is not None:
            return self.graph(inner)
        self.atom(tokens)
        return 1, 1, 1, True


def stripped(tokens):
    """What stands in the brackets, if tokens are nothing else, perhaps after !; else None."""
    rest = tokens
    while rest and rest[0][0] == '!':
        rest = rest[1:]
    if len(rest) != 1 or rest[0][0] != '(' or any(t[0] in ASSIGN or t[0] == ',' for t in rest[0][2]):
        return None
    return rest[0][2]


def conditional(tokens):
    """The three operands of the first ?: of a list."""
    names = [t[0] for t in tokens]
    first, depth = names.index('?'), 0
    for i in range(first, len(names)):
        depth += (names[i] == '?') - (names[i] == ':')
        if depth == 0:
            return tokens[:first], tokens[first + 1:i], tokens[i + 1:]
    raise SyntaxError(f'line {tokens[first][1]}: ? without :')


# What this file must find: how many conditions, and whether it is a tree.
SAMPLES = {
    'if (a && (b || c)) f();': [(3, True)],
    'if ((a || b) && c) f();': [(3, False)],
    'while (!(a && b) || !c) f();': [(3, True)],
    'while (!(a && b) && c) f();': [(3, False)],
    'do f(); while (p(a || b) && c == (a && b));': [(2, True), (2, True), (2, True)],
    'for (i = a || b; i < n && a && b; i++) f();': [(2, True), (3, True)],
    'return (a ? b : c) && d;': [(4, False)],
    'x = a || b ? c : (d && e);': [(2, True), (2, True)],
    'case 1: return a ? b : c; default: y = !(a || b);': [(1, True), (2, True)],
    'T t = {"a && b", (a || (b && c))}; /* a || b */': [(3, True)],
}


def main():
    for text, expected in SAMPLES.items():
        got = [decision[1:] for decision in Decisions(text)]
        assert got == expected, f'{text} gives {got}'
    files = [pathlib.Path(name) for name in sys.argv[1:]] or sorted(pathlib.Path('src').rglob('*.[ch]'))
    decisions = conditions = several = failed = 0
    for path in files:
        for line, count, tree in Decisions(path.read_text()):
            decisions += 1
            conditions += count
            several += count > 1
            if not tree:
                failed += 1
                print(f'{path}:{line}: not a tree: a condition of this decision is entered from two places')
    print(f'{decisions} decisions with {conditions} conditions, {several} of them with two or more')
    print(f'{decisions - failed} passed, {failed} failed, 0 skipped')
    return failed != 0 or decisions == 0


if __name__ == '__main__':
    sys.exit(main())
