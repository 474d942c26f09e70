"""Joins mutants, outcomes and the recorded equivalents: score, survivors, JSON, verdict."""

import json
import os
import sys
from collections import Counter

from page import page

DEAD = {"killed", "crashed", "hung"}
ALIVE = {"survived", "not reached"}


class Equivalents:
    """coverage/equivalent.txt: entries by what they match, each with its reason."""

    def __init__(self, path):
        self.reasons, self.path = {}, path
        reason = ""
        with open(path, encoding="utf-8") as file:
            for number, line in enumerate(file, 1):
                line = line.rstrip("\n")
                if not line or line.startswith("#"):
                    continue
                if line.startswith("because: "):
                    reason = line.removeprefix("because: ")
                    continue
                if line.count(" | ") < 3 or " -> " not in line:
                    fail(f"{path}:{number}: wants FILE | FUNCTION | LINE | ORIGINAL -> MUTATED: {line}")
                if not reason:
                    fail(f"{path}:{number}: comes before any line \"because: REASON\": {line}")
                if line in self.reasons:
                    fail(f"{path}:{number}: is there twice: {line}")
                self.reasons[line] = reason
        self.matched = set()

    def reason_of(self, mutant):
        for entry in (entry_of(mutant), entry_of(mutant | {"mutated": "*"})):
            if entry in self.reasons:
                self.matched.add(entry)
                return self.reasons[entry]
        return ""


def entry_of(mutant):
    which = f" #{mutant['occurrence']}" if mutant["occurrence"] > 1 else ""
    return (f"{mutant['file']} | {mutant['function']} | {mutant['text']} | "
            f"{mutant['original']}{which} -> {mutant['mutated']}")


def fail(message):
    print(f"coverage/mutants: {message}", file=sys.stderr)
    sys.exit(2)


def read_outcomes(path):
    outcomes = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            number, what, killer, on, tried = line.rstrip("\n").split("\t")
            outcomes[int(number)] = {"outcome": what, "by": killer, "on": on, "tried": int(tried)}
    return outcomes


def stale(equivalents, mutants, whole):
    """Entries that match nothing, or what a whole run has killed."""
    there = {entry_of(m) for m in mutants} | {entry_of(m | {"mutated": "*"}) for m in mutants}
    lines = [f"matches no mutant: {entry}" for entry in equivalents.reasons if entry not in there]
    if whole:
        alive = {entry_of(m) for m in mutants if m.get("outcome") in ALIVE}
        alive |= {entry_of(m | {"mutated": "*"}) for m in mutants if m.get("outcome") in ALIVE}
        lines += [f"is said to be equivalent, but is killed: {entry}"
                  for entry in equivalents.reasons if entry in there and entry not in alive]
    return lines


def tell(tried, survivors, equivalent, without, fixed):
    files = sorted({m["file"] for m in tried})
    print(f"{'file':<44}{'mutants':>8}{'killed':>8}{'alive':>7}{'equivalent':>12}")
    for file in files + [""]:
        of = [m for m in tried if file in ("", m["file"])]
        print(f"{file or 'all':<44}{len(of):>8}{sum(m['outcome'] in DEAD for m in of):>8}"
              f"{sum(m in survivors for m in of):>7}{sum(m in equivalent for m in of):>12}")
    print(f"{len(without)} more do not apply: the operands' types lack the operator")
    print("how: " + ", ".join(f"{n} {what}" for what, n in
                              Counter(m["outcome"] for m in tried).most_common()))
    by = Counter(m["by"].split(" ")[0] + (" " + m["by"].split(" ")[1] if m["by"].startswith("law")
                                          else "s") for m in tried if m["outcome"] in DEAD)
    print("by: " + ", ".join(f"{killer} {n}" for killer, n in by.most_common()))
    print("not switched, for the compiler evaluates them: " +
          ", ".join(f"{n} {why}" for why, n in Counter(f["why"] for f in fixed).most_common()))


def write_json(path, value):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(value, file, indent=1)


def main(build, out, floor, revision, budget):
    with open(f"{build}/mutants.json", encoding="utf-8") as file:
        listed = json.load(file)
    outcomes = read_outcomes(f"{build}/outcomes.txt")
    equivalents = Equivalents("coverage/equivalent.txt")
    mutants = [m | outcomes.get(m["id"], {}) for m in listed["mutants"]]
    tried = [m for m in mutants if m.get("outcome") in DEAD | ALIVE]
    whole = len(outcomes) == len(mutants)
    equivalent, survivors = [], []
    for m in tried:
        if m["outcome"] in ALIVE:
            m["reason"] = equivalents.reason_of(m)
            (equivalent if m["reason"] else survivors).append(m)
    os.makedirs(out, exist_ok=True)
    with open(f"{out}/survivors.txt", "w", encoding="utf-8") as file:
        for m in survivors:
            file.write(f"{m['file']}:{m['line']}:{m['column']} [{m['id']}, {m['outcome']}]\n"
                       f"  {entry_of(m)}\n")
    counted = len(tried) - len(equivalent)
    dead = counted - len(survivors)
    score = 100 * dead / counted if counted else 0
    summary = {"score_percent": round(score, 2), "tried": len(tried), "killed": dead,
               "equivalent": len(equivalent), "survivors": len(survivors), "whole": whole,
               "revision": revision, "budget": budget}
    write_json(f"{out}/mutation_score.json", summary)
    write_json(f"{out}/mutants.json", summary | {"mutants": [m for m in mutants if "outcome" in m],
                                                 "not_switched": listed["fixed"]})
    with open(f"{out}/mutants.html", "w", encoding="utf-8") as file:
        file.write(page(summary, tried, survivors, equivalent))
    without = [m for m in mutants if m.get("outcome") == "does not apply"]
    tell(tried, survivors, equivalent, without, listed["fixed"])
    print(f"score: {score:.2f} %: {dead} of {counted} mutants that are not recorded as equivalent "
          f"are killed; survivors: {out}/survivors.txt")
    problems = stale(equivalents, mutants, whole)
    for problem in problems:
        print(f"coverage/equivalent.txt: {problem}", file=sys.stderr)
    return 2 if problems else 1 if score < floor else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3], floor=float(sys.argv[3]), revision=sys.argv[4],
                  budget=sys.argv[5]))
