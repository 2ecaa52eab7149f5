"""Sphinx configuration of the site. app/site/run calls Sphinx with the output of app/site/pages.py and Doxygen."""

import logging
import os
import re

from sphinx import addnodes

project = "scb"
author = ""
extensions = ["myst_parser", "breathe"]
root_doc = "index"
language = "en"
smartquotes = False  # they would turn the hyphens of --json into a dash

myst_heading_anchors = 4
breathe_projects = {"scb": os.environ["SCB_SITE_XML"]}
breathe_default_project = "scb"
breathe_domain_by_extension = {"h": "cpp"}

# Names without a page: of numpy, the standard library, Eigen, the library's internals, and members of template arguments.
nitpick_ignore_regex = [
    ("py:class", r"(?!scb\.).*"),
    ("cpp:identifier", r"(std|Eigen)(::.*)?|u?int\d+_t|size_t|FILE"),
    ("cpp:identifier", r"(Vec3|Mat3|Vector3<T>|Matrix3<T>)::\w+|(Float|Quantized)Codec<.*|Parts|FitInput"),
]

html_theme = "furo"
html_title = "scb"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
templates_path = [os.path.join(os.path.dirname(__file__), "templates")]
html_static_path = [os.path.join(os.path.dirname(__file__), "static")]
html_css_files = ["site.css"]
pygments_style = "friendly"
pygments_dark_style = "monokai"


class NoSecondNamespace(logging.Filter):
    """Drops a warning: every header's page opens the namespace, but Sphinx expects a single declaration."""

    def filter(self, record):
        return ".. cpp:type:: scb'" not in record.getMessage()


def unwrap_namespace(app, doctree):
    """Moves a header's declarations out of the block of their namespace, to the top level of the page."""
    for block in list(doctree.findall(addnodes.desc)):
        if block["objtype"] == "type" and block[0].astext() == "namespace scb":
            page, at = block.parent, block.parent.index(block)
            page["ids"] += block[0]["ids"]
            page[at - 1 : at + 1] = block[-1].children[1:]  # without its entry in the index


def link_pictures(app, page, template, context, doctree):
    """Links each picture to its full size."""
    if "body" in context:
        context["body"] = re.sub(r'<img [^>]*src="([^"]+)"[^>]*>', r'<a href="\1">\g<0></a>', context["body"])


def setup(app):
    logging.getLogger("sphinx.sphinx.domains.cpp").addFilter(NoSecondNamespace())
    app.connect("doctree-read", unwrap_namespace)
    app.connect("html-page-context", link_pictures)
