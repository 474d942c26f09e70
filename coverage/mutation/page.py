"""The outcome as a page: per file how many are dead, each survivor, each equivalent's reason."""

from collections import Counter
from html import escape

STYLE = """
:root { color-scheme: light dark; } body { margin: 1rem auto; max-width: 75rem; padding: 0 1rem;
font: 16px/1.5 system-ui, sans-serif; } table { border-collapse: collapse; font-size: .9rem; }
th, td { padding: .2rem .7rem; border-bottom: 1px solid #8886; text-align: left;
vertical-align: top; } td.n { text-align: right; } code { overflow-wrap: anywhere; }
"""


def row(cells, tag="td"):
    return "<tr>" + "".join(
        f"<{tag} class=n>{c}</{tag}>" if isinstance(c, int) else f"<{tag}>{c}</{tag}>"
        for c in cells) + "</tr>\n"


def changed(mutant):
    return (f"<code>{escape(mutant['original'])}</code> to "
            f"<code>{escape(mutant['mutated'])}</code>")


def place(mutant):
    return f"<code>{escape(mutant['file'])}:{mutant['line']}</code>"


def page(summary, tried, survivors, equivalent):
    every, alive, same = (Counter(m["file"] for m in group)
                          for group in (tried, survivors, equivalent))
    files = row(["file", "mutants", "killed", "survive", "equivalent"], "th") + "".join(
        row([f"<code>{escape(f)}</code>", every[f], every[f] - alive[f] - same[f], alive[f],
             same[f]]) for f in sorted(every))
    living = row(["place", "what was changed", "outcome"], "th") + "".join(
        row([place(m), changed(m), m["outcome"]]) for m in survivors)
    reasons = row(["place", "what was changed", "why nothing can notice it"], "th") + "".join(
        row([place(m), changed(m), escape(m["reason"])]) for m in equivalent)
    whole = "all mutants" if summary["whole"] else "some of the mutants"
    return (f"<!doctype html>\n<html lang=en><head><meta charset=utf-8><title>Mutants</title>\n"
            f"<style>{STYLE}</style></head><body>\n<h1>Mutants of the mapper</h1>\n"
            f"<p>{summary['score_percent']:.2f} %: {summary['killed']} of "
            f"{summary['killed'] + summary['survivors']} that are not recorded as equivalent are "
            f"noticed by the laws or the tests; {whole}, of {escape(summary['revision'])}, tried with "
            f"{escape(summary['budget'])}. {summary['equivalent']} more are recorded as "
            f"equivalent.</p>\n"
            f"<table>{files}</table>\n<h2>Survivors</h2>\n<table>{living}</table>\n"
            f"<h2>Recorded as equivalent</h2>\n<table>{reasons}</table>\n</body></html>\n")
