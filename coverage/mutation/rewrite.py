"""The text of a file with its sites switched."""

M = "::selvage::mutants::"


def edits_of(site, first):
    """(offset, removed length, text, order) of a site whose first number is `first`.

    Of insertions at one offset, the ends of inner expressions come before those of outer ones, and
    the starts of outer ones before those of inner ones.
    """
    sign, start, end = site.sign, site.start, site.end
    length = end - start
    opening, closing = (1, -length), (0, length)
    functors = ", ".join(site.functors)
    replace_sign = (1, 0)
    if site.kind in ("binary", "assign") and site.sign.start != start:
        return [(start, 0, f"{M}{site.kind}<{first}, {functors_of(site)}>(", opening),
                (sign.start, len(sign.text), ",", replace_sign),
                (end, 0, ")", closing)]
    if site.kind == "logical":
        turned = f"{M}turned<{first}>("
        return [(start, 0, turned + turned, opening),
                (sign.start, len(sign.text), f") {sign.text} {turned}", replace_sign),
                (end, 0, "))", closing)]
    if site.kind == "unary":
        name = {"!": "negation", "-": "opposite", "~": "complement"}[sign.text]
        return [(start, len(sign.text), f"{M}{name}<{first}>(", opening), (end, 0, ")", closing)]
    if site.kind == "stepped":
        step = 1 if sign.text == "++" else -1
        return [(start, len(sign.text), f"{M}stepped<{first}, {step}>(", opening),
                (end, 0, ")", closing)]
    if site.kind == "stepped_after":
        step = 1 if sign.text == "++" else -1
        return [(start, 0, f"{M}stepped_after<{first}, {step}>(", opening),
                (sign.start, len(sign.text), ")", replace_sign)]
    if site.kind == "constant":
        return [(start, 0, f"{M}constant<{first}>(", opening), (end, 0, ")", closing)]
    if site.kind == "binary":  # a call: the name is replaced, its parentheses stay
        return [(start, length, f"{M}binary<{first}, {functors_of(site)}>", opening)]
    if site.kind in ("floored", "magnitude_of"):
        return [(start, length, f"{M}{site.kind}<{first}>", opening)]
    if site.kind in ("vector_call", "vector_shift"):
        return [(start, length, f"{site.kind}<{first}, {functors}>", opening)]
    raise ValueError(f"no rewriting for {site.kind}")


def functors_of(site):
    return ", ".join(M + functor for functor in site.functors)


def rewritten(source, sites):
    """`sites`: of this file, (first number, site)."""
    edits = []
    for first, site in sites:
        edits += edits_of(site, first)
    edits.sort(key=lambda edit: (edit[0], edit[3]))
    text, done = [], 0
    for offset, removed, new, _ in edits:
        if offset < done:
            raise ValueError(f"{source.path}: mutations overlap at {source.place(offset)}")
        text += [source.text[done:offset], new]
        done = offset + removed
    return "".join(text) + source.text[done:]
