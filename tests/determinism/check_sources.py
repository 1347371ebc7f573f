#!/usr/bin/env python3
"""Names that the engine, the rules and the replays must not use, because it could give other bits or
another order elsewhere (docs/determinism.md). Each rule brings examples, and is tried on them
before it is used.

A comment in the line above, with the reason, allows a sort by a key:

    // keys differ: they are the balls' ids
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FOLDERS = ("src/json", "include/carom", "include/games", "src/carom", "src/games", "src/search", "src/replay")

KEYS_DIFFER = "// keys differ: "

# Here floats choose what is then tested in doubles: they are rounded so that nothing is missed, and
# what is found in vain changes nothing.
FLOAT_FILES = ("include/carom/quadtree.hpp", "src/carom/quadtree.cpp",
               "src/carom/forecast.cpp", "src/carom/prediction.cpp",
               "src/carom/internal/forecast.hpp", "src/carom/fixed_parts.cpp",
               "src/carom/internal/fixed_parts.hpp",
               "src/carom/internal/kernel_loops.hpp", "src/carom/internal/kernels.hpp",
               "src/carom/internal/packed_index.hpp", "src/carom/internal/quadtree_search.hpp",
               "src/carom/internal/row_pairs.hpp", "src/carom/internal/vectors.hpp")

MATH = ("sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|sincos|pow|exp|exp2|expm1|"
        "log|log2|log10|log1p|hypot|cbrt|erf|erfc|tgamma|lgamma|fma|lerp")


class Rule:
    def __init__(self, name, pattern, bad, good=(), allowed_by=None, allowed_in=()):
        self.name = name
        self.pattern = re.compile(pattern)
        self.bad = bad
        self.good = good
        self.allowed_by = allowed_by
        self.allowed_in = allowed_in


RULES = (
    Rule("an order that the library chooses", r"\bunordered_(multi)?(map|set)\b",
         bad=("std::unordered_map<int, int> m;", "f('\"'); unordered_set<int> s; f('\"');",
              "#include <unordered_set>"),
         good=("std::map<int, int> m;", "// no unordered_map here", 'f("unordered_map");')),
    # Two iterators and no more: equal elements are then alike in all that < compares.
    Rule("a sort that leaves equal keys in any order",
         r"\b(std|ranges)::(partial_sort|nth_element|sort_heap|"
         r"sort(?!\((?:[\w.]|\(\))+, (?:[\w.+ ]|\(\))+\);))\s*\(|\bqsort\s*\(",
         bad=("std::sort(a.begin(), a.end(), by_x);", "std::ranges::sort(a, {}, &Ball::x);",
              "std::sort(a.begin(), a.end(),\n  [](int b, int c) {", "qsort (a, 1, 2, f);",
              "std::nth_element(a, b, c);"),
         good=("std::stable_sort(a, b, by_x);", "std::ranges::stable_sort(a);",
               "std::sort(a.begin(), a.end());", "std::sort(a, a + count_);", "list.sort();",
               KEYS_DIFFER + "ids\nstd::sort(a, b, by_id);"),
         allowed_by=KEYS_DIFFER),
    Rule("random numbers", r"<random>|\b(s?rand|rand_r|[dlm]rand48|random)\s*\(|\bmt19937|"
         r"\brandom_device\b|\bshuffle\s*\(",
         bad=("int i = rand();", "#include <random>", "std::mt19937_64 r;", "std::random_device d;",
              "std::ranges::shuffle(a, g);"),
         good=("strand(1);", "operand();")),
    Rule("clocks", r"<(chrono|ctime|time\.h|sys/time\.h)>|\bchrono\b|\bstd::(time|clock)\b|"
         r"\btime\s*\(\s*(nullptr|NULL|0|&\w+)\s*\)|(?<![\w.>])clock\s*\(\s*\)|"
         r"\b(gettimeofday|clock_gettime|timespec_get|ftime)\s*\(|\brdtscp?\b",
         bad=("#include <chrono>", "auto t = std::time(nullptr);", "std::chrono::seconds s;",
              "clock_gettime(CLOCK_MONOTONIC, &t);", "std::clock()", "time(0)"),
         good=("h = time_step / k;", "uptime(1);", "shown_.time() == 3", "int time() const;")),
    Rule("mathematics that libraries round differently", r"\b(" + MATH + r")[fl]?\s*\(",
         bad=("std::sin(x)", "x = cosf(y);", "std::pow(2, x)", "hypot (a, b)", "std::fma(a, b, c)",
              "std::lerp(a, b, t)", "expl(x)"),
         good=("std::sqrt(x)", "explain(x)", "cos_5_degrees * x", "catalog(x)", "std::abs(x)")),
    Rule("fused or approximate instructions", r"\b_mm\w*_(fn?m(add|sub)|rsqrt|rcp)|"
         r"\bv(fma|fms|rsqrte|rsqrts|recpe|recps)\w*q?_|\b__builtin_fma",
         bad=("_mm256_fmadd_pd(a, b, c)", "_mm_rsqrt_ps(a)", "vfmaq_f64(a, b, c)",
              "__builtin_fma(a, b, c)"),
         good=("_mm256_add_pd(a, b)", "vaddq_f64(a, b)")),
    Rule("another floating-point mode", r"<(cfenv|fenv\.h)>|\bfesetround\b|\bfp\s+(contract|reassociate)|"
         r"\bFP_CONTRACT\b|GCC\s+optimize|\boptimize\s*\(|_MM_SET_(FLUSH_ZERO|DENORMALS_ZERO)|\b_mm_setcsr\b",
         bad=("#include <cfenv>", "#pragma STDC FP_CONTRACT ON", '#pragma GCC optimize ("fast-math")',
              "#pragma clang fp contract(fast)", "__attribute__((optimize(\"O3\")))"),
         allowed_in=("include/carom/arithmetic.hpp",)),
    Rule("excess precision", r"\blong\s+double\b|\b__float128\b|\b_Float\d+x?\b|\bfloat_t\b|\bdouble_t\b",
         bad=("long double x;", "__float128 x;", "double_t x;"), good=("long doubled;",)),
    Rule("float, which keeps half the digits", r"\bfloat\b|\b(?!0[xX])\d+\.?\d*(e[-+]?\d+)?[fF]\b",
         bad=("float x;", "std::vector<float> v;", "static_cast<float>(x)", "x = 0.5f;"),
         good=("floating(x);", "x = 0.5;", "0x100000001b3", "0xff", "0x1F", "0xABCDEF01F"),
         allowed_in=FLOAT_FILES),
    Rule("sums in any order", r"<execution>|\bexecution::|\b(transform_)?reduce\s*\(|#\s*pragma\s+omp",
         bad=("#include <execution>", "std::reduce(a, b)", "std::transform_reduce (a, b, c)",
              "#pragma omp parallel"),
         good=("std::accumulate(a, b, 0)",)),
    Rule("an order of addresses", r"\b(multi)?(map|set)<[^<>,]*\*|\bless<[^<>]*\*\s*>|\bu?intptr_t\b",
         bad=("std::map<Ball*, int> m;", "std::set<const Ball *> s;", "std::less<Ball*>{}",
              "reinterpret_cast<std::uintptr_t>(p)"),
         good=("std::map<int, Ball*> m;", "std::set<int> s;")),
    Rule("a hash that the library chooses", r"\bstd::hash\b|\bhash_value\s*\(",
         bad=("std::hash<int>{}(1)",), good=("state_hash()",)),
    Rule("an atomic sum", r"\batomic(_ref)?\s*<\s*(double|float)\b",
         bad=("std::atomic<double> sum;", "std::atomic_ref<float> r;"),
         good=("std::atomic<int> n;",)),
    Rule("which thread this is", r"\bget_id\s*\(|\bthread::id\b|\b(pthread_self|gettid)\b|"
         r"\bhardware_concurrency\b",
         bad=("std::this_thread::get_id()", "std::thread::id id;", "pthread_self()",
              "std::thread::hardware_concurrency()")),
)

COMMENT_OR_STRING = re.compile(
    r"//[^\n]*|/\*.*?\*/|'(?:\\.|[^'\\\n])'|"
    r'R"(?P<mark>[^\s()\\]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def code_lines(text):
    """The lines without comments and without what is in strings; #include and #pragma stay whole."""
    def blank(match):
        start = text.rfind("\n", 0, match.start()) + 1
        if text.startswith("#pragma", start) and match[0].startswith('"'):
            return match[0]
        return "\n" * match[0].count("\n")
    return COMMENT_OR_STRING.sub(blank, text).split("\n")


def findings(text):
    """(line number, rule) of all that is wrong in a file."""
    lines = text.split("\n")
    for number, code in enumerate(code_lines(text), 1):
        for rule in RULES:
            allowed = rule.allowed_by and rule.allowed_by in lines[max(number - 2, 0)]
            if rule.pattern.search(code) and not allowed:
                yield number, rule


def try_rules():
    for rule in RULES:
        for example in rule.bad:
            if rule not in [found for _, found in findings(example)]:
                sys.exit(f"the rule against {rule.name} does not see: {example}")
        for example in rule.good:
            if list(findings(example)):
                sys.exit(f"the rule against {rule.name} is wrong about: {example}")


def main():
    try_rules()
    wrong = 0
    checked = 0
    for folder in FOLDERS:
        files = sorted(path for path in (ROOT / folder).rglob("*") if path.suffix in (".hpp", ".cpp"))
        if not files:
            sys.exit(f"{folder} has no sources")
        for path in files:
            checked += 1
            name = str(path.relative_to(ROOT))
            for number, rule in findings(path.read_text()):
                if name in rule.allowed_in:
                    continue
                print(f"{name}:{number}: {rule.name}")
                wrong += 1
    if wrong:
        sys.exit(1)
    print(f"{checked} files, {len(RULES)} rules, nothing found")


main()
