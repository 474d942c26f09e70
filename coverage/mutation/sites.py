"""Finds what can be mutated: operators and constants, by clang's syntax tree."""

import clang.cindex as clang

from tokens import Source

K = clang.CursorKind

# Operator: the functors of mutants.h, the original first.
BINARY = {
    "+": ("Plus", ["Minus"]),
    "-": ("Minus", ["Plus"]),
    "*": ("Times", ["Over"]),
    "/": ("Over", ["Times"]),
    "%": ("Modulo", ["Over"]),
    "<<": ("Left", ["Right"]),
    ">>": ("Right", ["Left"]),
    "&": ("BitAnd", ["BitOr"]),
    "|": ("BitOr", ["BitAnd"]),
    "^": ("BitXor", ["BitOr"]),
    "<": ("Less", ["LessEqual", "GreaterEqual"]),
    "<=": ("LessEqual", ["Less", "Greater"]),
    ">": ("Greater", ["GreaterEqual", "LessEqual"]),
    ">=": ("GreaterEqual", ["Greater", "Less"]),
    "==": ("Equal", ["NotEqual"]),
    "!=": ("NotEqual", ["Equal"]),
}
SIGNS = {functor: sign for sign, (functor, _) in BINARY.items()}
LOGICAL = {"&&": "||", "||": "&&"}
ARITHMETIC = {"BOOL", "CHAR_U", "UCHAR", "USHORT", "UINT", "ULONG", "ULONGLONG", "UINT128", "CHAR_S",
              "SCHAR", "SHORT", "INT", "LONG", "LONGLONG", "INT128", "FLOAT", "DOUBLE"}
FUNCTIONS = {K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.FUNCTION_TEMPLATE,
             K.CONVERSION_FUNCTION, K.DESTRUCTOR}
CLASSES = {K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE, K.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION}


class Site:
    """An operator or a constant. `alternatives` tells each mutation as text."""

    def __init__(self, source, kind, start, end, sign, alternatives, function):
        self.source, self.kind, self.start, self.end = source, kind, start, end
        self.sign = sign  # the operator's token; of a constant or a call the first
        self.alternatives, self.function = alternatives, function
        self.functors = []
        self.fixed = ""  # why it cannot be switched; empty if it can

    @property
    def key(self):
        return (self.source.path, self.start, self.end, self.kind)

    @property
    def original(self):
        return " ".join(self.source.text[self.start:self.end].split())


def is_named_constant(cursor):
    """constexpr, or const and made of nothing but constants."""
    words = [t.spelling for t in cursor.get_tokens()][:12]
    if "constexpr" in words:
        return True
    return cursor.type.is_const_qualified() and arithmetic(cursor.type) and not depends(cursor)


def arithmetic(of_type):
    return of_type.get_canonical().kind.name in ARITHMETIC


def depends(cursor):
    """On anything that is known only when the program runs."""
    for child in cursor.get_children():
        if child.kind in (K.MEMBER_REF_EXPR, K.CALL_EXPR, K.CXX_THIS_EXPR, K.LAMBDA_EXPR):
            return True
        if child.kind == K.DECL_REF_EXPR:
            of = child.referenced
            if of is None or of.kind == K.PARM_DECL:
                return True
            if of.kind == K.VAR_DECL and not is_named_constant(of):
                return True
        if child.type.get_canonical().kind.name in ("DEPENDENT", "FLOAT", "DOUBLE"):
            return True
        if depends(child):
            return True
    return False


def of_vectors(operator):
    """Whether it is an operator of a class that is made anew for each SIMD target: a function that
    is compiled for all of them cannot call it. Its definition is mutated."""
    at = operator.type.get_canonical().get_declaration().location.file
    return at is not None and at.name.endswith("-inl.h")


def value_of(literal):
    """Of a floating-point literal; one that comes from a macro is not 0 here."""
    text = literal.rstrip("fFlL")
    try:
        return float.fromhex(text) if "x" in text else float(text)
    except ValueError:
        return 1.0


class Finder:
    def __init__(self, sources):
        self.sources = sources  # path: Source; of the files to be mutated
        self.sites = {}
        self.functions = []  # path, start, end, name

    def function_at(self, path, offset):
        """The name of the innermost function there; empty if there is none."""
        around = [f for f in self.functions if f[0] == path and f[1] <= offset < f[2]]
        return min(around, key=lambda f: f[2] - f[1])[3] if around else ""

    def visit_unit(self, cursor):
        for child in cursor.get_children():
            file = child.location.file
            if file and file.name in self.sources:
                self.visit(child, [], "at namespace scope")

    def visit(self, cursor, names, fixed):
        kind = cursor.kind
        if kind in FUNCTIONS or kind in CLASSES:
            if cursor.location.file and cursor.location.file.name not in self.sources:
                return
            names = names + [cursor.spelling.split("<")[0]]
            if kind in FUNCTIONS:
                fixed = ""
                extent = cursor.extent
                self.functions.append((cursor.location.file.name, extent.start.offset,
                                       extent.end.offset, "::".join(names)))
        elif kind == K.LAMBDA_EXPR:
            fixed = ""
        elif kind == K.FIELD_DECL and not cursor.is_bitfield():
            fixed = ""  # a default member initialiser runs with the constructor
        elif kind == K.STATIC_ASSERT:
            fixed = "in a static_assert"
        elif kind == K.VAR_DECL and is_named_constant(cursor):
            fixed = "in the definition of a constant, which is mutated at its uses"
        elif kind in (K.ENUM_CONSTANT_DECL, K.TYPE_ALIAS_DECL, K.TEMPLATE_NON_TYPE_PARAMETER):
            fixed = "in a declaration"
        elif kind == K.CXX_UNARY_EXPR or kind == K.SIZE_OF_PACK_EXPR:
            fixed = "in a sizeof"
        if kind in (K.DECL_REF_EXPR, K.TEMPLATE_REF, K.TYPE_REF, K.OVERLOADED_DECL_REF):
            self.look_at(cursor, names, fixed)
            fixed = fixed or "a template's argument"
            return self.visit_children(cursor, names, fixed)
        self.look_at(cursor, names, fixed)
        self.visit_children(cursor, names, fixed)

    def visit_children(self, cursor, names, fixed):
        children = list(cursor.get_children())
        for place, child in enumerate(children):
            why = fixed
            if not why:
                why = self.fixed_child(cursor, place, child)
            self.visit(child, names, why)

    def fixed_child(self, parent, place, child):
        source = self.source_of(child)
        if source is None:
            return ""
        if parent.kind == K.CASE_STMT and place == 0:
            return "a case label"
        if parent.kind == K.IF_STMT and place == 0:
            i = source.index_from(parent.extent.start.offset)
            if source.tokens[i + 1].text == "constexpr":
                return "the condition of an if constexpr"
        if parent.kind in (K.VAR_DECL, K.FIELD_DECL, K.PARM_DECL) and child.kind.is_expression():
            i = source.index_from(child.extent.end.offset)
            if i < len(source.tokens) and source.tokens[i].text == "]":
                return "the bound of an array"
            if child.extent.end.offset <= parent.location.offset:
                return "a template's argument"
        return ""

    def source_of(self, cursor):
        file = cursor.extent.start.file
        return self.sources.get(file.name) if file else None

    def look_at(self, cursor, names, fixed):
        source = self.source_of(cursor)
        if source is None:
            return
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        first = source.index_at(start)
        if first is None or end <= start:
            return
        site = self.site_of(cursor, source, start, end, first)
        if site is None:
            return
        site.function = "::".join(names)
        site.fixed = fixed
        if site.key not in self.sites:
            self.sites[site.key] = site

    def site_of(self, cursor, source, start, end, first):
        token = source.tokens[first]
        alone, kind = token.end == end, cursor.kind
        if alone or kind == K.DECL_REF_EXPR:
            return self.constant(cursor, source, token, end)
        if kind in (K.BINARY_OPERATOR, K.COMPOUND_ASSIGNMENT_OPERATOR):
            return self.binary(cursor, source, start, end)
        if kind == K.CALL_EXPR and cursor.spelling.startswith("operator"):
            return None if of_vectors(cursor) else self.binary(cursor, source, start, end)
        if kind == K.UNARY_OPERATOR:
            return self.unary(source, start, end, first)
        return None

    def constant(self, cursor, source, token, end):
        if token.kind not in ("name", "number"):
            return None  # the 0 that a comparison by <=> is rewritten with
        literal = cursor.kind in (K.INTEGER_LITERAL, K.FLOATING_LITERAL, K.CXX_BOOL_LITERAL_EXPR)
        if cursor.kind == K.DECL_REF_EXPR:
            of = cursor.referenced
            if of is None or of.kind not in (K.VAR_DECL, K.TEMPLATE_NON_TYPE_PARAMETER):
                return None
            if of.kind == K.VAR_DECL and not is_named_constant(of):
                return None
        elif not literal:
            return None
        kind = cursor.type.get_canonical().kind.name
        if kind not in ARITHMETIC and kind not in ("DEPENDENT", "UNEXPOSED"):
            return None
        text = source.text[token.start:end]
        if kind == "BOOL":
            told = [f"!{text}"]
        elif kind in ("FLOAT", "DOUBLE"):
            zero = literal and value_of(text) == 0
            told = ["1", "-1"] if zero else [f"2 * {text}", f"{text} / 2"]
        else:
            told = [f"{text} + 1", f"{text} - 1"]
        return Site(source, "constant", token.start, end, token, told, "")

    def binary(self, cursor, source, start, end):
        children = list(cursor.get_children())
        if len(children) < 2:
            return None
        i = source.index_from(children[0].extent.end.offset)
        if i >= len(source.tokens):
            return None
        sign = source.tokens[i]
        if not (start < sign.start < sign.end < end) or sign.end > children[-1].extent.start.offset:
            return None
        text = source.text

        def told(new):
            return " ".join((text[start:sign.start] + new + text[sign.end:end]).split())

        if sign.text in LOGICAL:
            return Site(source, "logical", start, end, sign, [told(LOGICAL[sign.text])], "")
        kind, operator = "binary", sign.text
        if operator.endswith("=") and operator[:-1] in BINARY and operator not in BINARY:
            kind, operator = "assign", operator[:-1]
        if operator not in BINARY:
            return None
        functor, others = BINARY[operator]
        suffix = "=" if kind == "assign" else ""
        site = Site(source, kind, start, end, sign,
                    [told(SIGNS[other] + suffix) for other in others], "")
        site.functors = [functor] + others
        return site

    def unary(self, source, start, end, first):
        text, token = source.text, source.tokens[first]
        rest = " ".join(text[token.end:end].split())
        if token.text in ("!", "-", "~"):
            return Site(source, "unary", start, end, token, [rest], "")
        if token.text in ("++", "--"):
            other = "--" if token.text == "++" else "++"
            return Site(source, "stepped", start, end, token, [other + rest], "")
        last = source.tokens[source.index_from(end) - 1]
        if last.text in ("++", "--") and last.end == end:
            other = "--" if last.text == "++" else "++"
            told = " ".join(text[start:last.start].split()) + other
            return Site(source, "stepped_after", start, end, last, [told], "")
        return None
