"""Calls that are operators in other words: std::min, Highway's functions."""

from sites import Site

STANDARD = {
    "min": ("binary", ["Least", "Greatest"], "max"),
    "max": ("binary", ["Greatest", "Least"], "min"),
    "floor": ("floored", [], "ceil"),
    "abs": ("magnitude_of", [], ""),
}
MACROS = {"hwy_min": (["Least", "Greatest"], "HWY_MAX"), "hwy_max": (["Greatest", "Least"], "HWY_MIN")}
HIGHWAY = {
    "Add": "Sub", "Sub": "Add", "Mul": "Add", "Div": "Mul", "MulAdd": "MulSub", "Min": "Max",
    "Max": "Min", "And": "Or", "Or": "And", "Xor": "Or", "Lt": "Le", "Eq": "Ne", "Ne": "Eq",
    "Floor": "Ceil", "AllFalse": "NotAllFalse", "AllTrue": "NotAllTrue", "IfThenElse": "IfElseThen",
}
SHIFTS = {"ShiftLeft": "ShiftRight", "ShiftRight": "ShiftLeft"}


def calls(source, function_at):
    """The sites of a file; function_at(offset) names the function there, or is empty."""
    found = []
    tokens = source.tokens
    for i in range(len(tokens) - 3):
        site = None
        if tokens[i + 1].text == "::" and tokens[i + 3].text in ("(", "<"):
            site = qualified(source, i)
        elif tokens[i].text in MACROS and tokens[i + 1].text == "(":
            functors, other = MACROS[tokens[i].text]
            site = call_site(source, "binary", i, i, other, functors)
        if site is not None:
            site.function = function_at(site.start)
            site.fixed = "" if site.function else "at namespace scope"
            found.append(site)
    return found


def qualified(source, i):
    tokens = source.tokens
    space, name, opening = tokens[i].text, tokens[i + 2].text, tokens[i + 3].text
    if i > 0 and tokens[i - 1].text == "::":
        return None
    if space == "std" and name in STANDARD and opening == "(":
        kind, functors, other = STANDARD[name]
        return call_site(source, kind, i, i + 2, f"std::{other}" if other else "", functors)
    if space == "hn" and name in HIGHWAY and opening == "(":
        other = HIGHWAY[name]
        functors = [f"Vector{name}", f"Vector{other}"]
        return call_site(source, "vector_call", i, i + 2, f"hn::{other}", functors)
    if space == "hn" and name in SHIFTS and opening == "<":
        end = i + 4
        while tokens[end].text != ">":
            end += 1
        bits = source.text[tokens[i + 4].start:tokens[end].start]
        told = [f"hn::{SHIFTS[name]}<{bits}>", f"hn::{name}<{bits} + 1>", f"hn::{name}<{bits} - 1>"]
        site = Site(source, "vector_shift", tokens[i].start, tokens[end].end, tokens[i], told, "")
        site.functors = [bits, "true" if name == "ShiftLeft" else "false"]
        return site
    return None


def call_site(source, kind, first, last, other, functors):
    tokens = source.tokens
    site = Site(source, kind, tokens[first].start, tokens[last].end, tokens[first],
                [other or "(the argument)"], "")
    site.functors = functors
    return site
