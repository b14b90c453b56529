#!/usr/bin/python3
"""Lists the sentences of the modules that a window or a report may show, one a line; %1, %2 .. stand for what is put in.

Usage: core_sentences.py ROOT [report]. It reads ROOT/modules, without those folders whose texts reach only files, logs and
the command line. ui/shell/shown_words.cpp finds a shown text in this list; update.py takes it into the catalogues.
"""
import itertools
import pathlib
import re
import sys

# Their words stand in a report alone, single ones too.
REPORT = ("show/report/src/report_events", "show/report/src/report_field", "show/report/src/report_protocol", "show/report/src/report_targets",
          "show/report/src/session_report", "show/report/include/facenav/report/session_notes.h")
# Their texts reach only files, logs and the command line.
LEFT_OUT = ("lab/", "show/report/src/report_html", "show/report/src/chart.cpp", "show/report/src/pulse_map",
            "base/core/src/settings", "steps/methods/", "plan/other_words", "shell/appearance", "shell/report_pdf")
# Here a single word is shown too.
WITH_WORDS = ("steps/align/src/alignment_seen.cpp", "treat/session/src/loop/navigation_state.cpp", "show/report/src/pulse_columns.cpp",
              "target/guidance/src/instruction.cpp", "rig/health/src/verify_rig.cpp", "steps/setup/src/setup_steps.cpp")
UNITS = {"deg", "mm", "ms", "px"}
TOKEN = re.compile(r'''R"(?P<d>[^(]*)\((?:.|\n)*?\)(?P=d)"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|//[^\n]*|/\*(?:.|\n)*?\*/
                       |^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*|[A-Za-z_][\w:]*|\d[\w.']*|[-+]=|->|[=!<>]=|&&|\|\||<<|>>|\s+|.''', re.X | re.M)
FORMAT = re.compile(r"%[-+ #0]*(?:\d+|\*)?(?:\.(?:\d+|\*))?(?:hh|h|ll|l|z)?[diuoxXfFeEgGsc]")
# Brackets whose texts are not shown, or are marked for translation already.
NOT_SHOWN = re.compile(r"^(log\w*|FACENAV_EXPECT|static_assert|visitor|Evidence|f?printf|tr|translate|QT_TRANSLATE_NOOP|setStyleSheet"
                       r"|QRegularExpression|toString|fromString)$")
EDGE = " ,;:.\n"


def tokens_of(text):
    """Tokens without space, comments and preprocessor lines; adjacent literals are joined."""
    tokens = []
    for match in TOKEN.finditer(text):
        token = match.group()
        if not token.strip() or token.startswith(("//", "/*")) or token.lstrip().startswith("#"):
            continue
        if token.startswith('"') and tokens and tokens[-1].startswith('"'):
            tokens[-1] = tokens[-1][:-1] + token[1:]
        else:
            tokens.append(token)
    return tokens


def literal(token):
    return re.sub(r"\\(x[0-9a-fA-F]+|.)", lambda m: {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}.get(m.group(1), "\0"), token[1:-1])


class Reader:
    """Reads the tokens of one file as nested lists: a list is what lies in brackets."""

    def __init__(self, tokens):
        self.found, self.read = [], set()
        self.tree = self.nest(iter(tokens))

    def nest(self, tokens):
        out = []
        for token in tokens:
            if token in "([{" and len(token) == 1:
                out.append(("([{".index(token), self.nest(tokens)))
            elif token in ")]}" and len(token) == 1:
                return out
            else:
                out.append(token)
        return out

    def walk(self, items):
        part = []
        for item in list(items) + [";"]:
            if isinstance(item, str) and item in (",", ";", "=", "+=", "return", "<<", "==", "!=", "&&", "||", "throw"):
                self.expression(part)
                part = []
            else:
                part.append(item)

    def expression(self, part):
        """One expression without commas: notes its sentences, then looks into its brackets."""
        self.found += self.texts(part)
        self.inside(part)

    def inside(self, part):
        for before, item in zip([None] + part, part):
            if not isinstance(item, tuple) or isinstance(before, str) and NOT_SHOWN.match(before.split("::")[-1]):
                continue
            if id(item) not in self.read:
                self.walk(item[1])
            elif before == "formatted":
                self.walk([";"] + item[1][1:])
            else:
                self.inside(item[1])

    def texts(self, part):
        """All texts that an expression may give, a null character for each inserted value."""
        if not part:
            return []
        if "?" in part and ":" in part:
            at, depth = part.index("?"), 0
            for i in range(at + 1, len(part)):
                depth += {"?": 1, ":": -1}.get(part[i], 0) if isinstance(part[i], str) else 0
                if depth < 0:
                    return self.texts(part[at + 1:i]) + self.texts(part[i + 1:])
        sums = [list(group) for is_plus, group in itertools.groupby(part, lambda item: item == "+") if not is_plus]
        return ["".join(each) for each in itertools.islice(itertools.product(*map(self.term, sums)), 16)]

    def term(self, items):
        if len(items) == 1 and isinstance(items[0], str):
            return [plain(literal(items[0]))] if items[0].startswith('"') else ["\0"]
        if len(items) == 1 and items[0][0] == 0 and any(isinstance(i, str) and i.startswith('"') for i in items[0][1]):
            self.read.add(id(items[0]))
            return self.texts(items[0][1])
        if len(items) == 2 and isinstance(items[1], tuple) and items[1][1]:
            inside = items[1][1]
            if items[0] == "formatted" and isinstance(inside[0], str) and inside[0].startswith('"'):
                self.read.add(id(items[1]))
                return self.filled(literal(inside[0]), inside[2:])
            if items[0] in ("std::string", "string") and "," not in inside:
                self.read.add(id(items[1]))
                return self.texts(inside)
        return ["\0"]

    def filled(self, form, arguments):
        """A format with its values: a value that is one of some words gives a text for each."""
        values = [list(group) for is_comma, group in itertools.groupby(arguments, lambda item: item == ",") if not is_comma]
        pieces = [piece.replace("\1", "%") for piece in FORMAT.split(form.replace("%%", "\1"))]
        texts = [pieces[0]]
        for i, piece in enumerate(pieces[1:]):
            words = self.texts(values[i]) if i < len(values) else []
            words = words if words and not any("\0" in each for each in words) else ["\0"]
            texts = [text + word + piece for text in texts for word in words][:16]
        return texts


def plain(text):
    """The text without the marks of a format, for a function that passes it on."""
    return re.sub(r"%[-+#0]*\d*(?:\.\d+)?[lz]*[diuxfgsc](?![a-z])", "\0", text).replace("%%", "%")


def trimmed(text):
    """The text without what joins it to its neighbours, as ShownWords trims it: separators, and brackets without a partner."""
    text = text.strip(EDGE)
    while text.count(")") > text.count("(") and text.endswith(")") or text.count("(") > text.count(")") and text.endswith("("):
        text = text[:-1].strip(EDGE)
    while text.count("(") > text.count(")") and text.startswith("(") or text.count(")") > text.count("(") and text.startswith(")"):
        text = text[1:].strip(EDGE)
    return text


def template(text, least_words=2):
    """The text with %1, %2 .. for its values and without loose ends; nothing if it is no sentence."""
    text = trimmed(re.sub("\0+", "\0", text))
    words = re.findall(r"(?<![\w./-])[A-Za-z]*[a-z]{2,}(?![\w/]|\.\w)", text.replace("\0", " "))
    is_code = "\n" in text or "//" in text or re.match(r"[<{\[]|.*<[a-z/]", text) or least_words > 1 and not re.search(r"[a-z] | [a-z]", text)
    is_title = least_words == 1 and re.fullmatch(r"[A-Z]{3,}( [A-Z]{3,})+", text)
    if not is_title and (len(set(words) - UNITS) < least_words or is_code):
        return None
    numbers = itertools.count(1)
    return re.sub("\0", lambda m: "%" + str(next(numbers)), text)


def sources(root):
    """Each source file and its path below modules/ or ui/."""
    for folder in ("modules", "ui"):
        top = pathlib.Path(root) / folder
        for path in sorted(top.rglob("*")):
            place = path.relative_to(top).as_posix()
            if path.suffix in (".cpp", ".h") and not place.startswith(LEFT_OUT):
                yield place, path.read_text()


def templates(text, least_words):
    reader = Reader(tokens_of(text))
    reader.walk(reader.tree)
    return [sentence for each in reader.found if (sentence := template(each, least_words))]


def sentences(root):
    """Each sentence that the window may show, and the file that holds it first."""
    found = {}
    for place, text in sources(root):
        if "/include/" in place or place.startswith(REPORT):
            continue
        for sentence in templates(text, 1 if place in WITH_WORDS else 2):
            found.setdefault(sentence, place)
    return found


def report_sentences(root):
    """Each sentence and word that only a report shows: its own ones, and the names of a session's events."""
    found = {}
    for place, text in sources(root):
        for name in re.findall(r'\baddEvent\(\s*"([^"]+)"', text):
            found.setdefault(name, place)
        if place.startswith(REPORT):
            for sentence in templates(text, 1):
                found.setdefault(sentence, place)
    of_window = sentences(root)
    return {sentence: place for sentence, place in found.items() if sentence not in of_window}


if __name__ == "__main__":
    listed = report_sentences if "report" in sys.argv[2:] else sentences
    for sentence in listed(sys.argv[1]):
        print(sentence)
