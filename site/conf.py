"""How Sphinx makes the site. site/run calls it, with what site/pages.py and Doxygen wrote."""

import os

project = "scb"
author = ""
extensions = ["myst_parser", "breathe"]
root_doc = "index"
language = "en"

myst_heading_anchors = 4
breathe_projects = {"scb": os.environ["SCB_SITE_XML"]}
breathe_default_project = "scb"
breathe_domain_by_extension = {"h": "cpp"}

# The standard library and Eigen have no pages here.
nitpick_ignore_regex = [("cpp:identifier", r"(std|Eigen)(::.*)?|u?int\d+_t|size_t|FILE")]

html_theme = "furo"
html_title = "scb"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_static_path = [os.path.join(os.path.dirname(__file__), "static")]
html_css_files = ["site.css"]
pygments_style = "friendly"
pygments_dark_style = "monokai"
