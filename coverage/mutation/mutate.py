"""Writes the tree with all mutants in it, and the list of them."""

import hashlib
import json
import os
import re
import sys
from collections import Counter

import clang.cindex as clang

from calls import calls
from rewrite import rewritten
from sites import Finder
from tokens import Source

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ROOMS = ["CMakeLists.txt", "src", "spec", "tests", "coverage"]
BESIDE = ["src/snap.cpp", "src/fit.cpp"]  # mutated too, besides src/mapper
NOT_BUILT = ["src/mapper/vector/absent.cpp"]
# The first number of a file is a multiple of this (and above 0), so that few others' numbers change
# with one file and few are compiled anew.
ROUND = 128
# Debian names its file so.
clang.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")
TEMPLATE_CALL = re.compile(r"\b[A-Za-z_]\w*<([^<>;(){}]*)>\(")
SHUFFLE = re.compile(r"\b__builtin_shufflevector\(([^;(){}]*)\)")
OTHER_TARGETS = re.compile(r"^#if HWY_TARGET == HWY_(?:SSE4|AVX2|AVX3)\b(?:(?!^#endif).)*?^#else\n"
                           r"(.*?)^#endif", re.MULTILINE | re.DOTALL)
MACROS = re.compile(r"\bHWY_(MIN|MAX|LIKELY|UNLIKELY)\b(?=\()")


def mutated_files():
    files = sorted(os.path.join(folder, name)
                   for folder, _, names in os.walk("src/mapper") for name in names)
    return [f for f in files + BESIDE if f not in NOT_BUILT and f.endswith((".cpp", ".h"))]


def clang_arguments():
    headers = ["/usr/lib/llvm-19/lib/clang/19/include"]
    return ["-x", "c++", "-std=c++20", "-Isrc", '-DSELVAGE_VERSION=""', "-isystem"] + headers


def find(sources):
    arguments, index, finder = clang_arguments(), clang.Index.create(), Finder(sources)
    unsaved = [(path, source.text) for path, source in sources.items()]
    stand_ins = ["-include", os.path.join(os.path.dirname(__file__), "mutants.h")]
    for path in sources:
        if not path.endswith(".cpp"):
            continue
        unit = index.parse(path, args=arguments + stand_ins, unsaved_files=unsaved)
        errors = [str(d) for d in unit.diagnostics if d.severity >= clang.Diagnostic.Error]
        if errors:
            sys.exit(f"mutate: clang cannot read {path}:\n" + "\n".join(errors[:5]))
        finder.visit_unit(unit.cursor)
    sites = list(finder.sites.values())
    for path, source in sources.items():
        sites += calls(source, lambda offset, path=path: finder.function_at(path, offset))
    return sites


def in_shifts(sites):
    """What a switched shift by a constant holds cannot be switched by itself."""
    shifts = [s for s in sites if s.kind == "vector_shift"]
    for site in sites:
        for shift in shifts:
            inside = shift.start <= site.start and site.end <= shift.end
            if site is not shift and site.source is shift.source and inside:
                site.fixed = "a template's argument"


def fix_where(sites, pattern, why):
    """Those within the first group of a match are not switched."""
    ranges = {}
    for site in sites:
        path = site.source.path
        if path not in ranges:
            ranges[path] = [m.span(1) for m in pattern.finditer(site.source.text)]
        inside = any(start <= site.start and site.end <= end for start, end in ranges[path])
        if inside and not site.fixed:
            site.fixed = why


def in_template_arguments(sites):
    """Of functions whose templates the syntax tree does not resolve: it shows no arguments there."""
    fix_where(sites, TEMPLATE_CALL, "a template's argument")


def in_shuffles(sites):
    """The compiler takes nothing but constants for the places of a shuffled vector's elements."""
    fix_where(sites, SHUFFLE, "the place of an element in a shuffle")


def of_other_processors(sites):
    """What stands under #else of a condition on x86-64's SIMD targets is not compiled here."""
    for site in sites:
        for match in OTHER_TARGETS.finditer(site.source.text):
            if match.start(1) <= site.start < match.end(1) and not site.fixed:
                site.fixed = "for processors other than x86-64 (tests/cross/run)"


def write_if_changed(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if os.path.exists(path):
        with open(path, encoding="utf-8", errors="surrogateescape") as file:
            if file.read() == text:
                return
    with open(path, "w", encoding="utf-8", errors="surrogateescape") as file:
        file.write(text)


def is_built_from(name):
    return name == "CMakeLists.txt" or not name.endswith((".py", ".pyc", ".txt", ".md", ".svg"))


def mirror(tree, mutated):
    """The project, with the mutated files in the place of their originals."""
    kept = set()
    for room in ROOMS:
        for folder, _, names in os.walk(room) if os.path.isdir(room) else [(".", [], [room])]:
            if folder.startswith("coverage/out"):
                continue
            for name in filter(is_built_from, names):
                path = os.path.normpath(os.path.join(folder, name))
                with open(path, encoding="utf-8", errors="surrogateescape") as file:
                    write_if_changed(f"{tree}/{path}", mutated.get(path) or file.read())
                kept.add(path)
    for name in ("mutants.h", "mutants-inl.h"):
        with open(f"coverage/mutation/{name}", encoding="utf-8") as file:
            write_if_changed(f"{tree}/src/mapper/{name}", file.read())
        kept.add(f"src/mapper/{name}")
    for folder, _, names in os.walk(tree):
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), tree)
            if path not in kept:
                os.remove(os.path.join(tree, path))


def switched(source, numbered):
    text = rewritten(source, numbered)
    anchor = "namespace hn = hwy::HWY_NAMESPACE;\n"
    if anchor in text:
        text = text.replace(anchor, anchor + '#include "mapper/mutants-inl.h"\n')
    return '#include "mapper/mutants.h"\n' + text


def digest(*words):
    return hashlib.sha256(" | ".join(map(str, words)).encode()).hexdigest()


def words_of(mutant):
    return [mutant[k] for k in ("file", "function", "text", "original", "mutated", "occurrence")]


def count_occurrences(mutants):
    """Tells mutants apart that read the same: the first, second ... from the left."""
    seen = Counter()
    for mutant in mutants:
        same = tuple(mutant[k] for k in ("file", "function", "text", "original", "mutated"))
        seen[same] += 1
        mutant["occurrence"] = seen[same]
        mutant["name"] = digest(*words_of(mutant))[:16]


def sampled(mutants, count, seed, inside=()):
    """As if at random, and so that a change of the sources changes little of the sample; where parts
    of paths are given, of files whose paths have one of them."""
    asked = [m for m in mutants if not inside or any(part in m["file"] for part in inside)]
    first = sorted(asked, key=lambda m: digest(seed, *words_of(m)))[:count]
    return sorted(first, key=lambda m: m["id"])


def listed(mutants, sources):
    """For the program: number, number of the site, name, hash of the file's text; the path."""
    texts = {path: digest(source.text)[:16] for path, source in sources.items()}
    return "".join(f"{m['id']} {m['site']} {m['name']} {texts[m['file']]} {m['file']}\n"
                   for m in mutants)


def main(build, sample, seed, inside):
    os.chdir(TOP)
    sources = {}
    for path in mutated_files():
        with open(path, encoding="utf-8") as file:
            text = MACROS.sub(lambda m: m.group().lower(), file.read())
        sources[path] = Source(path, text)
    sites = find(sources)
    in_shifts(sites)
    in_template_arguments(sites)
    in_shuffles(sites)
    of_other_processors(sites)
    sites.sort(key=lambda s: (s.source.path, s.start, -s.end, s.kind))
    mutants, fixed, per_file, number = [], [], {path: [] for path in sources}, 1
    for site in sites:
        if not per_file[site.source.path] and not site.fixed:
            number += -number % ROUND
        line, column = site.source.place(site.start)
        place = {"file": site.source.path, "line": line, "column": column,
                 "function": site.function, "text": site.source.line(site.start).replace("hwy_", "HWY_")}
        if site.fixed:
            fixed.append(place | {"original": site.original, "why": site.fixed})
            continue
        per_file[site.source.path].append((number, site))
        for alternative in site.alternatives:
            mutants.append({"id": number, "site": per_file[site.source.path][-1][0], **place,
                            "kind": site.kind, "original": site.original, "mutated": alternative})
            number += 1
    count_occurrences(mutants)
    chosen = mutants
    if sample:
        chosen = sampled(mutants, sample, seed, inside)
        if not chosen:
            sys.exit(f"no path of a file with mutants has {' or '.join(inside)} in it")
        kept = {m["site"] for m in chosen}
        per_file = {path: [s for s in numbered if s[0] in kept]
                    for path, numbered in per_file.items()}
    mutated = {path: switched(source, per_file[path]) for path, source in sources.items()}
    mirror(f"{build}/tree", mutated)
    write_if_changed(f"{build}/mutants.json",
                     json.dumps({"mutants": mutants, "fixed": fixed}, indent=1))
    write_if_changed(f"{build}/sites.txt", listed(chosen, sources))
    print(f"{len(mutants)} mutants at {sum(map(len, per_file.values()))} sites; "
          f"{len(fixed)} sites that the compiler evaluates")


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), sys.argv[5::2])
