#!/usr/bin/python3
"""Makes the manual of resources/doc: a site that can be searched, and a PDF.

make_manual.py OUT [--pictures DIR] [--pdf]
  OUT/html      the site; it works from files, without a network
  OUT/facenav-manual.pdf  with --pdf
A page asks for a picture in a comment of its Markdown: <!-- picture: NAME words that describe it -->. DIR holds NAME.png; a blank
in a file's name stands for _.
A picture that is not there is left out. A link to a file outside the manual becomes plain text.
"""
import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # nothing is made beside the sources
from refusals import as_markdown  # noqa: E402

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PAGES = ROOT / "resources" / "doc"
REFUSALS = "<!-- every refusal of the code -->"  # a page asks for the list so
LINK = re.compile(r"(?<!!)\[((?:`[^`]*`|[^\[\]`])*)\]\(([^)\s]+)\)")
PICTURE = re.compile(r"^<!-- picture: (\S+) (.+?) -->$", re.M)


def site_link(match, pages):
    words, link = match.groups()
    page, hash_, heading = link.partition("#")
    if "://" in link or page == "":
        return match.group(0)
    if page not in pages:
        return words
    if words == page:
        words = pages[page]
    return f"[{words}]({'index.md' if page == 'README.md' else page}{hash_}{heading})"


def site_text(text, pages, pictures):
    """A part of a page without blocks of code, as the site's generator reads it."""
    def picture_of(match):
        name, words = match.groups()
        return f"![{words}](pictures/{name}.png)\n\n*{words}*" if name in pictures else ""

    text = LINK.sub(lambda match: site_link(match, pages), PICTURE.sub(picture_of, text))
    return text.replace(REFUSALS, as_markdown(ROOT)) if REFUSALS in text else text


def site_page(text, pages, pictures):
    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
    return "".join(part if part.startswith("```") else site_text(part, pages, pictures) for part in parts)


def name_of(text):
    """The page's name: its first heading up to a colon."""
    return re.match(r"# ([^:\n]+)", text).group(1)


def order_of(index, pages):
    """The pages in the order in which the index names them first; then the others by name."""
    named = [page for page in re.findall(r"\]\(([a-z-]+\.md)", index) if page in pages]
    return list(dict.fromkeys(named + sorted(set(pages) - {"README.md"})))


def stage(folder, pictures_folder):
    """Writes the pages and pictures that the site is made from. Returns the pages in order, without the index."""
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "pictures").mkdir(parents=True)
    pages = {path.name: name_of(path.read_text(encoding="utf-8")) for path in PAGES.glob("*.md")}
    pictures = {path.stem.replace(" ", "_"): path for path in pictures_folder.glob("*.png")} if pictures_folder else {}
    for name in sorted(pages):
        text = (PAGES / name).read_text(encoding="utf-8")
        page = site_page(text, pages, pictures)
        if name == "README.md":
            order = [each[:-3] for each in order_of(text, pages)]
            page += "\n```{toctree}\n:hidden:\n:maxdepth: 1\n\n" + "\n".join(order) + "\n```\n"
        (folder / ("index.md" if name == "README.md" else name)).write_text(page, encoding="utf-8")
    used = set(re.findall(r"\]\(pictures/(\S+)\.png\)", "".join(path.read_text(encoding="utf-8") for path in folder.glob("*.md"))))
    for name in used:
        from PIL import Image  # it takes a third of the room in 256 colours
        Image.open(pictures[name]).convert("RGB").quantize(256).save(folder / "pictures" / f"{name}.png", optimize=True)
    return order, used


def main():
    parser = argparse.ArgumentParser(description="Makes the manual of resources/doc.")
    parser.add_argument("out", type=Path)
    parser.add_argument("--pictures", type=Path, help="folder of the pictures that the program made")
    parser.add_argument("--pdf", action="store_true", help="makes the PDF, too")
    given = parser.parse_args()
    out = given.out.resolve()
    order, used = stage(out / "pages", given.pictures)
    shutil.rmtree(out / "html", ignore_errors=True)
    made = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-E", "-W", "--keep-going", "-b", "html", "-c", HERE, "-d", out / "doctrees",
                           out / "pages", out / "html"])
    shutil.rmtree(out / "doctrees", ignore_errors=True)
    if made.returncode != 0:
        sys.exit("manual: the site could not be made; see above")
    for leftover in (".buildinfo", "objects.inv"):
        (out / "html" / leftover).unlink(missing_ok=True)
    if given.pdf:
        from printing import print_manual  # it needs packages that the site does not
        print_manual(out / "html", ["index"] + order, HERE / "print.css", out / "facenav-manual.pdf")
    print(f"{len(order) + 1} pages, {len(used)} pictures")


main()
