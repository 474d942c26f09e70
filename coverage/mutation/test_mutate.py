"""Mutates a small source and looks at what comes out."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from mutate import (count_occurrences, find, in_shifts, in_shuffles, in_template_arguments,
                    of_other_processors, sampled)
from rewrite import rewritten
from sites import Site
from tokens import Source

TEXT = """\
#include <algorithm>
constexpr int kMost = 1 << 3;
static_assert(kMost == 8);
bool any(int a, bool on) { return a <= kMost && !on; }
int step(int a) {
  for (int i = 0; i < 2; ++i) a -= -std::min(a, 5);
  return a;
}
template <class T> T half(T a) { return a / 2.0; }
int labelled(int a) {
  switch (a) { case 4: return sizeof(int) * 1; }
  int held[kMost + 1] = {};
  return held[0]; // + 1 in a comment
}
template <class T> struct Held {
  template <int kBy> T by(T a) const { return a + kBy; }
  T more(T a) const { return by<3>(a); }
};
"""


def sites_of(text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "small.cpp")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        source = Source(path, text)
        sites = find({path: source})
    in_shifts(sites)
    in_template_arguments(sites)
    return source, sorted(sites, key=lambda s: (s.start, -s.end))


class Mutate(unittest.TestCase):
    def setUp(self):
        self.source, self.sites = sites_of(TEXT)
        self.switched = [s for s in self.sites if not s.fixed]

    def mutations(self, function):
        return [(s.original, a) for s in self.switched if s.function == function
                for a in s.alternatives]

    def test_operators_and_constants(self):
        self.assertEqual(self.mutations("any"), [
            ("a <= kMost && !on", "a <= kMost || !on"),
            ("a <= kMost", "a < kMost"), ("a <= kMost", "a > kMost"),
            ("kMost", "kMost + 1"), ("kMost", "kMost - 1"), ("!on", "on")])
        self.assertEqual(self.mutations("step"), [
            ("0", "0 + 1"), ("0", "0 - 1"), ("i < 2", "i <= 2"), ("i < 2", "i >= 2"),
            ("2", "2 + 1"), ("2", "2 - 1"), ("++i", "--i"),
            ("a -= -std::min(a, 5)", "a += -std::min(a, 5)"),
            ("-std::min(a, 5)", "std::min(a, 5)"), ("std::min", "std::max"),
            ("5", "5 + 1"), ("5", "5 - 1")])

    def test_templates(self):
        self.assertEqual(self.mutations("half"), [
            ("a / 2.0", "a * 2.0"), ("2.0", "2 * 2.0"), ("2.0", "2.0 / 2")])

    def test_what_the_compiler_evaluates_is_listed(self):
        told = {(s.original, s.fixed) for s in self.sites if s.fixed}
        for wanted in [("1 << 3", "in the definition of a constant, which is mutated at its uses"),
                       ("kMost == 8", "in a static_assert"), ("kMost + 1", "the bound of an array"),
                       ("4", "a case label"), ("3", "a template's argument")]:
            self.assertIn(wanted, told)

    def test_what_other_processors_run_is_listed(self):
        text = ("#if HWY_TARGET == HWY_SSE4\nint here(int a) { return a + 1; }\n#else\n"
                "int there(int a) { return a - 1; }\n#endif\nint any(int a) { return a * 3; }\n")
        source = Source("small.cpp", text)
        sites = [Site(source, "constant", text.index(c), text.index(c) + 1, None, [], "")
                 for c in "+-*"]
        of_other_processors(sites)
        self.assertEqual([bool(s.fixed) for s in sites], [False, True, False])

    def test_places_in_a_shuffle_are_listed(self):
        text = "V f(V a) { return __builtin_shufflevector(a, a, 1, 2) + 3; }\n"
        source = Source("small.cpp", text)
        sites = [Site(source, "constant", text.index(c), text.index(c) + 1, None, [], "")
                 for c in "123"]
        in_shuffles(sites)
        self.assertEqual([bool(s.fixed) for s in sites], [True, True, False])

    def test_a_sample_is_of_the_texts(self):
        def mutants(first):
            told = [{"id": first + i, "file": "a", "function": "f", "text": "t", "original": str(i),
                     "mutated": "0"} for i in range(100)]
            count_occurrences(told)
            return told

        def originals(first, seed):
            return [m["original"] for m in sampled(mutants(first), 10, seed)]
        self.assertEqual(len(originals(1, 1)), 10)
        self.assertEqual(originals(1, 1), originals(7, 1))
        self.assertNotEqual(originals(1, 1), originals(1, 2))

    def test_a_sample_may_be_of_some_files(self):
        mutants = [{"id": i, "file": f"src/{'abc'[i % 3]}.cpp", "function": "f", "text": "t",
                    "original": str(i), "mutated": "0"} for i in range(30)]
        count_occurrences(mutants)
        files = {m["file"] for m in sampled(mutants, 100, 1, ["a.c", "src/c"])}
        self.assertEqual(files, {"src/a.cpp", "src/c.cpp"})

    def test_the_text_with_switches(self):
        number, numbered = 1, []
        for site in self.switched:
            numbered.append((number, site))
            number += len(site.alternatives)
        text = rewritten(self.source, numbered)
        m = "::selvage::mutants::"
        self.assertIn(f"return {m}turned<1>({m}turned<1>({m}binary<2, {m}LessEqual, {m}Less, "
                      f"{m}Greater>(a , {m}constant<4>(kMost)) ) && {m}turned<1>( "
                      f"{m}negation<6>(on)));", text)
        self.assertIn("static_assert(kMost == 8);\nbool any", text)
        self.assertIn("int held[kMost + 1] = {};", text)
        self.assertIn("// + 1 in a comment", text)


if __name__ == "__main__":
    unittest.main()
