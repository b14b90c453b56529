"""Prints the manual's site as one PDF: cover, contents, one chapter a page."""
import re
from pathlib import Path
from xml.etree import ElementTree

import html5lib

HEADINGS = ("h1", "h2")


def body_of(path):
    """The element that holds the page's text."""
    tree = html5lib.parse(path.read_text(encoding="utf-8"), namespaceHTMLElements=False)
    return next(each for each in tree.iter("div") if each.get("role") == "main")


def make_own(body, page, pages):
    """Makes names of places unique by the page's name, and links lead to places of the same document."""
    for each in body.iter():
        if each.get("id"):
            each.set("id", f"{page}--{each.get('id')}")
        link = each.get("href")
        if link is None:
            continue
        to, _, heading = link.partition("#")
        to = page if to == "" else to[:-5] if to.endswith(".html") else to
        if to in pages:
            each.set("href", f"#{to}--{heading}" if heading else f"#page-{to}")


def contents_of(bodies):
    """Contents of all chapters down to their sections, as HTML."""
    lines = []
    for page, body in bodies:
        sections = []
        for section in body.iter("section"):
            heading = next((each for each in section if each.tag in HEADINGS), None)
            if heading is None:
                continue
            words = "".join(heading.itertext()).replace("\u00b6", "").strip()
            words = words.replace("&", "&amp;").replace("<", "&lt;")
            if heading.tag == "h1":
                lines.append(f'<li><a href="#page-{page}">{words}</a>')
            else:
                sections.append(f'<li><a href="#{section.get("id")}">{words}</a></li>')
        lines.append(f"<ul>{''.join(sections)}</ul></li>")
    return f'<nav class="contents"><h2>Contents</h2><ul>{"".join(lines)}</ul></nav>'


def print_manual(site, pages, style, pdf):
    from weasyprint import CSS, HTML  # needed for the PDF alone

    bodies = []
    for page in pages:
        body = body_of(site / f"{page}.html")
        make_own(body, page, set(pages))
        bodies.append((page, body))
    title = re.search("<title>.*?(FaceNav [0-9.]+)", (site / "index.html").read_text(encoding="utf-8"), re.S).group(1)
    parts = [f'<section class="cover"><h1>{title}</h1><p>The manual</p><p>Not a medical device: for research and development.</p></section>',
             contents_of(bodies)]
    for page, body in bodies:
        text = ElementTree.tostring(body, encoding="unicode", method="html")
        parts.append(f'<section class="page" id="page-{page}">{text}</section>')
    document = f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{title}: the manual</title></head><body>{"".join(parts)}</body></html>'
    HTML(string=document, base_url=str(Path(site).resolve()) + "/").write_pdf(pdf, stylesheets=[CSS(filename=str(style))])
