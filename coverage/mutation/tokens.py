"""A C++ source as tokens with offsets: enough to find operators and names."""

import re

_TOKEN = re.compile(
    r"""
    (?P<space>\s+|\\\n)
  | (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>(?<![^\n])[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<string>(?:u8|[uUL])?(?:"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'))
  | (?P<number>\.?[0-9](?:[eEpP][+-]|'[0-9A-Za-z]|[0-9A-Za-z_.])*)
  | (?P<name>[A-Za-z_][A-Za-z0-9_]*)
  | (?P<sign><=>|<<=|>>=|->\*|\.\.\.|::|\+\+|--|->|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)
    """,
    re.VERBOSE | re.DOTALL,
)


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start = kind, text, start

    @property
    def end(self):
        return self.start + len(self.text)


class Source:
    """The text of a file; offsets are those of clang, which counts bytes: sources are ASCII."""

    def __init__(self, path, text):
        self.path, self.text = path, text
        if not text.isascii():
            raise ValueError(f"{path}: not ASCII; offsets would be wrong")
        self.tokens = []
        for match in _TOKEN.finditer(text):
            if match.lastgroup not in ("space", "comment", "directive"):
                self.tokens.append(Token(match.lastgroup, match.group(), match.start()))
        self._starting = {token.start: i for i, token in enumerate(self.tokens)}
        self._line_starts = [0] + [m.end() for m in re.finditer("\n", text)]

    def index_at(self, offset):
        """The index of the token that starts here, or None."""
        return self._starting.get(offset)

    def index_from(self, offset):
        """The index of the first token that starts here or later."""
        low, high = 0, len(self.tokens)
        while low < high:
            middle = (low + high) // 2
            if self.tokens[middle].start < offset:
                low = middle + 1
            else:
                high = middle
        return low

    def place(self, offset):
        """Line and column, from 1."""
        low, high = 0, len(self._line_starts)
        while high - low > 1:
            middle = (low + high) // 2
            if self._line_starts[middle] <= offset:
                low = middle
            else:
                high = middle
        return low + 1, offset - self._line_starts[low] + 1

    def line(self, offset):
        line = self.place(offset)[0]
        return " ".join(self.text.split("\n")[line - 1].split())
