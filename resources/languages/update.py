#!/usr/bin/python3
"""Brings the catalogues of the window's languages up to date with the sources.

Usage: update.py [CODE ..]. Without a code: every catalogue here. A new code ("de") begins a language: translate
facenav_de.ts with Qt Linguist, and the next build has it. New texts come in as unfinished, unused ones go.
"""
import pathlib
import subprocess
import sys
import tempfile

import core_sentences

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parent.parent


def update(catalogue):
    """Runs lupdate on the window's sources and on the sentences of the modules and of reports; returns its summary and its warnings."""
    with tempfile.TemporaryDirectory() as folder:
        core = pathlib.Path(folder) / "core.cpp"
        texts = [("core", text) for text in core_sentences.sentences(ROOT)]
        texts += [("report", text) for text in core_sentences.report_sentences(ROOT)]
        quoted = [(context, text.replace("\\", "\\\\").replace('"', '\\"')) for context, text in texts]
        core.write_text("".join(f'static const char* t{i} = QT_TRANSLATE_NOOP("{context}", "{text}");\n'
                                for i, (context, text) in enumerate(quoted)))
        code = catalogue.stem.split("_", 1)[1]
        done = subprocess.run(["lupdate", "-locations", "none", "-no-obsolete", "ui", "app/gui_main.cpp", str(core),
                               "-target-language", code, "-ts", str(catalogue)], cwd=ROOT, capture_output=True, text=True)
        if done.returncode:
            sys.exit(done.stderr)
        return done.stdout, done.stderr.splitlines()


if __name__ == "__main__":
    named = [FOLDER / f"facenav_{code}.ts" for code in sys.argv[1:]]
    for each in named or sorted(FOLDER.glob("facenav_*.ts")):
        print(update(each)[0], end="")
