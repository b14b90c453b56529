"""Lists every message that refuses something, with what to do, as the code states both.

An Error holds what happened, where, and a remedy (modules/base/core). This reads them from the sources: each Error that is
thrown or returned, also by a function of the same file that makes one. ".." stands for a value that differs from case to case.
"""
import re
from pathlib import Path

GROUPS = {"base": "Files, numbers and settings", "scan": "Scan, archive and head model", "rig": "Cameras and calibration",
          "face": "The face, and the alignment", "track": "Tracking", "target": "Targets, coils and field",
          "case": "The case, and files of other programs", "treat": "Sessions, pulses and other programs",
          "show": "Pictures and report", "steps": "Steps of a case", "app": "The command line", "ui": "The window"}
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
VALUE = re.compile(r"%[-+0-9.*]*(?:zu|lld|ld|[dfsguci])")
HELPER = re.compile(r"^(?:\[\[noreturn\]\] )?(?:void|Error) (\w+)\(([^;{]*?)\) \{\n(.*?)^\}", re.M | re.S)


def arguments_at(text, start):
    """The arguments of the call whose bracket opens before `start`."""
    found, depth, begin, at = [], 1, start, start
    while at < len(text) and depth > 0:
        if text[at] == '"':
            at = STRING.match(text, at).end() if STRING.match(text, at) else at + 1
            continue
        if text[at] == "'" and text[at + 2:at + 3] == "'":
            at += 3
            continue
        if text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            depth -= 1
        if depth == 0 or (depth == 1 and text[at] == ","):
            found.append(text[begin:at].strip())
            begin = at + 1
        at += 1
    return found


def words_of(expression, known):
    """The text that the expression makes; `known` gives the texts of variables."""
    expression = re.sub(r'"\s*\n\s*"', "", expression)
    if re.match(r"(core::)?formatted\(", expression):
        expression = arguments_at(expression, expression.index("(") + 1)[0]
    words, at = "", 0
    for literal in list(STRING.finditer(expression)) + [None]:
        between = expression[at:literal.start() if literal else len(expression)]
        names = [known[name] for name in re.findall(r"\w+", between) if name in known]
        if names:
            words += names[0]
        elif words and re.fullmatch(r"\s*:\s*", between):
            words += " / "
        elif re.search(r"[\w)]", re.sub(r"std::string|\?.*", "", between)) and not words.endswith(".."):
            words += ".."
        if literal:
            words += VALUE.sub("..", literal.group(1)).replace("%%", "%").replace('\\"', '"').replace("\\\\", "\\")
            at = literal.end()
    return re.sub(r"\s+", " ", words.replace("\\n", " ")).strip()


def message_of(arguments, known):
    """What happened and what to do, in words."""
    words = [words_of(each, known) for each in arguments]
    remedies = [each for each in words[1:] if re.search(r"[a-z]{2}", each)]
    return words[0], (words[2] if len(words) > 2 and words[2] else remedies[-1] if len(words) > 3 and remedies else "")


def messages_in(text, kinds):
    """Pairs of message and remedy in a source."""
    makes = re.compile(r"\b(?:throw|return) (?:\w+::)*(?:%s)\(" % "|".join(sorted(kinds)))
    for call in makes.finditer(text):
        yield message_of(arguments_at(text, call.end()), {})
    for helper in HELPER.finditer(text):
        inside = makes.search(helper.group(3))
        if not inside:
            continue
        names = [re.sub(r"\s*=.*", "", each).split()[-1].strip("&*") for each in helper.group(2).split(",") if each.strip()]
        made = arguments_at(helper.group(3), inside.end())
        for call in re.finditer(r"(?<![\w.>] )(?<![\w])%s\(" % helper.group(1), text):
            if helper.start() <= call.start() < helper.end():
                continue
            given = [words_of(each, {}) for each in arguments_at(text, call.end())]
            yield message_of(made, dict(zip(names, given)))


def refusals(root):
    """Group -> sorted pairs of message and remedy, of all sources below `root`."""
    sources = {path: re.sub(r"^\s*//.*$", "", path.read_text(encoding="utf-8"), flags=re.M)
               for folder in ("modules", "app", "ui") for ending in ("*.cpp", "*.h") for path in sorted((root / folder).rglob(ending))}
    kinds = {"Error"}
    for _ in range(3):  # classes of errors, and those of these
        for text in sources.values():
            kinds |= {name for name, base in re.findall(r"(?:class|struct) (\w+) (?:final )?: (?:public )?(?:\w+::)*(\w+)", text) if base in kinds}
    found = {}
    for path, text in sources.items():
        parts = path.relative_to(root).parts
        group = parts[1] if parts[0] == "modules" else parts[0]
        if group in GROUPS and "lab" not in parts:
            found.setdefault(group, set()).update(pair for pair in messages_in(text, kinds) if re.search(r"[a-z]{3}", pair[0]))
    return {group: sorted(found.get(group, ()), key=lambda pair: (pair[0].lstrip(". '"), pair[1])) for group in GROUPS}


def as_markdown(root):
    def cell(words):
        return words.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_").lstrip(". ") or " "

    lines = []
    for group, pairs in refusals(root).items():
        lines += [f"### {GROUPS[group]}", "", "| it says | what to do |", "|---|---|"]
        lines += [f"| {cell(what)} | {cell(remedy)} |" for what, remedy in pairs] + [""]
    return "\n".join(lines)


if __name__ == "__main__":
    print(as_markdown(Path(__file__).resolve().parents[2]))
