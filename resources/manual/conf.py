# Sphinx's settings of the manual. make_manual.py gives the folder of pages, made from resources/doc.
import re
from pathlib import Path

_root = Path(__file__).resolve().parents[2]
_version = re.search(r"project\(FaceNav VERSION ([0-9.]+)", (_root / "CMakeLists.txt").read_text(encoding="utf-8"))

project = "FaceNav"
version = release = _version.group(1)
copyright = "FaceNav developers; Apache-2.0"
html_title = f"FaceNav {version}: the manual"
html_short_title = "FaceNav"
language = "en"
root_doc = "index"
extensions = ["myst_parser"]
myst_heading_anchors = 4
myst_enable_extensions = []
myst_linkify_fuzzy_links = False
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]
nitpicky = True

html_theme = "alabaster"
html_theme_options = {"description": f"The manual of version {version}", "show_powered_by": False, "page_width": "1180px",
                      "sidebar_width": "260px", "font_family": "DejaVu Sans, Arial, sans-serif",
                      "head_font_family": "DejaVu Sans, Arial, sans-serif", "code_font_family": "DejaVu Sans Mono, monospace"}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_static_path = [str(Path(__file__).resolve().parent / "manual.css")]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sourcelink = False
html_use_index = False
# A page opened as a file may not read other files: the search shows titles without a piece of their text.
html_show_search_summary = False

# The search needs neither of these; the other scripts are Sphinx's own.
_unused = ("jquery.js", "underscore.js", "_sphinx_javascript_frameworks_compat.js")


def _drop_unused(app, page, template, context, doctree):
    context["script_files"] = [each for each in context.get("script_files", [])
                               if not str(getattr(each, "filename", each)).endswith(_unused)]


def _remove_unused(app, fault):
    if fault is None and app.builder.name == "html":
        for path in Path(app.outdir, "_static").glob("*.js"):
            if re.sub(r"-[0-9.]+(?=\.js$)", "", path.name) in _unused:
                path.unlink()


def setup(app):
    app.connect("html-page-context", _drop_unused)
    app.connect("build-finished", _remove_unused)
