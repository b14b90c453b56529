#!/usr/bin/python3
"""Checks the window's languages; prints a line for each fault, and nothing if all is well.

1. Each catalogue has each text of the sources, translated and finished, and no other text.
2. A translation has the values of its text: the same %1, %2 .., %n.
3. Each text that the window's code gives to a widget is marked by tr().
"""
import pathlib
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import core_sentences
import update

WIDGETS = re.compile(r"^(set(Text|ToolTip|StatusTip|WhatsThis|Title|WindowTitle|PlaceholderText|AccessibleName|AccessibleDescription|Suffix|Prefix"
                     r"|HeaderLabels|HorizontalHeaderLabels|TabText)|add(Action|Menu|Item|Items|Tab|Button|Section)|showMessage|refused|said|drawText"
                     r"|QLabel|QPushButton|QToolButton|QCheckBox|QRadioButton|QGroupBox|QAction|QMenu|ElidedLabel|NarrowLabel)$")
MARKED = ("tr", "translate", "shownWords", "QT_TRANSLATE_NOOP", "toString", "fromString")
NO_CLASS = "Class 'facenav::ui' lacks"  # functions of the namespace translate in its name


def messages(path):
    """Each text of a catalogue by context and source."""
    found = {}
    for context in ElementTree.parse(path).getroot().findall("context"):
        for message in context.findall("message"):
            found[context.findtext("name"), message.findtext("source")] = message.find("translation")
    return found


def forms(translation):
    """The translation's forms: one, or one for each plural."""
    plurals = translation.findall("numerusform")
    return ["".join(each.itertext()) for each in (plurals or [translation])]


def values(text):
    return sorted(set(re.findall(r"%L?\d+|%n", text)))


def catalogue_faults(path):
    """Faults of one catalogue: what lupdate would change in a copy, and translations that lack a value."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / path.name
        shutil.copy(path, copy)
        warnings = update.update(copy)[1]
        wanted, there = messages(copy), messages(path)
    faults = [line.split(": ", 1)[1] for line in warnings if "lacks Q_OBJECT" in line and NO_CLASS not in line]
    faults += [f"{path.name} lacks, in {context}: {source}" for context, source in wanted.keys() - there.keys()]
    faults += [f"{path.name} has an unused text, in {context}: {source}" for context, source in there.keys() - wanted.keys()]
    for (context, source), translation in there.items():
        if (context, source) not in wanted:
            continue
        if translation.get("type") or not all(forms(translation)):
            faults.append(f"{path.name} does not translate, in {context}: {source}")
        for form in forms(translation):
            if form and not translation.get("type") and values(form) != values(source):
                faults.append(f"{path.name} has other values, in {context}: {source} -> {form}")
    return faults


def unmarked(items, is_shown=False, is_example=False):
    """The literals with words that a widget gets without tr(); QStringLiteral marks names and examples of input."""
    for before, item in zip([None] + items, items):
        if isinstance(item, tuple):
            name = re.split(r"::", before)[-1] if isinstance(before, str) else ""
            if name not in MARKED:
                yield from unmarked(item[1], bool(WIDGETS.match(name)) or (is_shown and item[0] != 2), name == "QStringLiteral")
        elif is_shown and item.startswith('"'):
            text = re.sub(r"<[^>]*>|:/\S*", "", core_sentences.literal(item))
            if re.search(r"[a-z]{3,} [a-z]{3,}" if is_example else r"[a-z]{3}", text):
                yield core_sentences.literal(item)


def unread(items):
    """What tr() gets in place of a literal; lupdate does not see such a text, so it has no translation."""
    for before, item in zip([None] + items, items):
        if isinstance(item, tuple):
            if before == "tr" and item[0] == 0 and item[1] and isinstance(item[1][0], str) and not item[1][0].startswith(('"', "const", "QString")):
                yield "".join(each for each in item[1] if isinstance(each, str))
            yield from unread(item[1])


def window_faults(root):
    for path in sorted((root / "ui").rglob("*")):
        if path.suffix in (".cpp", ".h"):
            text_of_file = path.read_text()
            tree = core_sentences.Reader(core_sentences.tokens_of(text_of_file)).tree
            for text in unmarked(tree):
                yield f"{path.relative_to(root)} shows a text without tr(): {text}"
            for value in unread(tree) if "QT_TRANSLATE_NOOP" not in text_of_file else []:
                yield f"{path.relative_to(root)} gives tr() a value, use shownWords or QT_TRANSLATE_NOOP: {value}"


if __name__ == "__main__":
    all_faults = [fault for path in sorted(update.FOLDER.glob("facenav_*.ts")) for fault in catalogue_faults(path)]
    all_faults += window_faults(update.ROOT)
    print("\n".join(all_faults), end="\n" if all_faults else "")
    sys.exit(1 if all_faults else 0)
