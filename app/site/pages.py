"""pages.py OUT: writes the input of Sphinx: the manuals at the paths that their links expect, a gallery of their pictures,
and a page per public header. Run in the project's root."""

import os
import pathlib
import re
import shutil
import sys

from python_pages import python_page

out = pathlib.Path(sys.argv[1])

# The manuals in the order of the site's list.
MANUALS = [
    "README.md",
    "app/README.md",
    "app/view/README.md",
    "app/python/README.md",
    "render/README.md",
    "scenes/README.md",
    "scenes/recordings/README.md",
    "scenes/recordings/engines.md",
    "scenes/recordings/broken.md",
    "scenes/recordings/broken-distances.md",
    "golden/README.md",
    "core/README.md",
    "app/packages/README.md",
    "tests/peers/README.md",
    "app/site/README.md",
    "CHANGELOG.md",
]
MANUALS += ["tests/volumes/README.md", "tests/tried.md"]
# The pages that an index links to, in its folder, in the order of its links: guides, reference, topics.
for index in ("app/README.md", "core/README.md"):
    folder = os.path.dirname(index)
    found = re.findall(r"\]\(((?:guides|reference|topics)/[\w-]+\.md)", pathlib.Path(index).read_text())
    pages = [f"{folder}/{page}" for page in dict.fromkeys(found)]
    missing = {path.as_posix() for name in ("guides", "reference", "topics") for path in pathlib.Path(folder, name).glob("*.md")} - set(pages)
    if missing:
        sys.exit(f"{index} links to these pages nowhere: {', '.join(sorted(missing))}.")
    MANUALS[MANUALS.index(index) + 1 : MANUALS.index(index) + 1] = pages
# The captions of the pages of some folders; the others are manuals.
CAPTIONS = {"app/guides": "Guides", "app/reference": "Reference of the program", "core": "Library", "core/topics": "Library"}
HEADERS = sorted(
    path.relative_to("core/include").as_posix()
    for path in pathlib.Path("core/include").rglob("*.h")
    if "detail" not in path.parts
)
# A block or span of code, which is not changed, or a link.
CODE_OR_LINK = re.compile(
    r"^ *```.*?^ *```$|`[^`\n]+`|!?\[(?P<text>(?:[^][]|\[[^][]*\])*)\]\((?P<target>[^)\s]+)\)", flags=re.M | re.S
)


def page_of(manual):
    """The page of a manual; README.md becomes the folder's index page."""
    return manual.replace("README.md", "index.md")


def linked(folder, match):
    """A link in the site: to a page, to a header's page, or to a copy of a file; or only the link's text."""
    text, target = match["text"], match["target"]
    if not target:
        return match.group()
    path, hash_sign, anchor = target.partition("#")
    if re.match(r"[a-z]+:", target) or not path:
        return match.group()
    there = os.path.normpath(os.path.join(folder, path))
    if there.startswith("core/include/"):
        page = "reference/" + there.removeprefix("core/include/").replace(".h", ".md")
        return f"[{text}]({os.path.relpath(page, folder or '.')})"
    if there in MANUALS:
        return f"[{text}]({page_of(path)}{hash_sign}{anchor})"
    if not os.path.exists(there):
        sys.exit(f"a manual in {folder or 'the root'} links to {path}, which is not there.")
    if os.path.isdir(there):
        return text
    copy = out / there
    copy.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(there, copy)
    return match.group()


def write(page, text):
    path = out / page
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def toctree(caption, pages):
    return f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n" + "\n".join(pages) + "\n```\n"


def title_of(text):
    return re.search(r"^# (.*)", text).group(1)


def slug(heading):
    """The anchor of a heading, as in tests/manuals/run."""
    return re.sub(r"[^A-Za-z0-9 _-]", "", heading).replace(" ", "-").lower()


def pictures_of(manual, text):
    """Each picture with its title, its heading, and the commands before it under that heading."""
    folder, heading, commands = os.path.dirname(manual), None, ""
    pattern = r"^#+ (?P<heading>[^\n]*)|^```(?P<language>\w*)\n(?P<code>.*?)^```$|^!\[(?P<title>[^\n]*)\]\((?P<path>[^\n]*)\)$"
    for match in re.finditer(pattern, text, flags=re.M | re.S):
        if match["heading"]:
            heading, commands = match["heading"], ""
        elif match["language"] == "sh":
            commands = match["code"]
        elif match["path"]:
            path = os.path.normpath(os.path.join(folder, match["path"]))
            yield path, match["title"], heading, commands


def gallery(texts):
    shown, parts = set(), []
    # A picture in several manuals is listed with render/README.md if possible, and with the root's README.md only if no other manual has it.
    for manual in sorted(MANUALS, key=lambda name: (name != "render/README.md", name == "README.md")):
        cards = []
        for path, title, heading, commands in pictures_of(manual, texts[manual]):
            if path in shown:
                continue
            shown.add(path)
            link = page_of(manual) + ("#" + slug(heading) if heading != title_of(texts[manual]) else "")
            card = f"````{{container}} picture\n![{title}]({path})\n\n{title}. [How to read it]({link})\n"
            cards.append(card + (f"\n```sh\n{commands}```\n" if commands else "") + "````\n")
        if cards:
            parts.append(f"## {title_of(texts[manual])}\n\n" + "\n".join(cards))
    for path in sorted(pathlib.Path("render/pictures").glob("*.png")):
        if path.as_posix() not in shown:
            sys.exit(f"{path} is in no manual, and so not in the gallery.")
    head = "# Gallery\n\nEvery picture of the manuals, and the commands that make it.\n\n"
    return head + "\n".join(parts)


def reference(core_manual):
    said = dict(re.findall(r"^\| `(scb/[^`]*\.h)` \| (.*) \|$", core_manual, flags=re.M))
    rows = "".join(
        f"| [{header}]({header.replace('.h', '.md')}) | {said[header]} |\n" for header in said if header in HEADERS
    )
    others = [header for header in HEADERS if header not in said]
    listed = ", ".join(f"[{header}]({header.replace('.h', '.md')})" for header in others)
    return (
        "# C++ headers\n\nThe public headers of [the library](../core/index.md), and what each of them declares. "
        "{ref}`The index <genindex>` has all names.\n\n"
        "Lengths are in the unit of the meshes, whatever it is; areas and volumes are in its square and cube. Everything that "
        "bounds a mesh is in the frame of its body. A pose takes one frame to another. A and B are the two sides of a query, "
        "and results are in A's frame. What is wrong with the input is an InputError; a parameter `name` says there which "
        "mesh it is. Functions that are documented as the same take the same arguments.\n\nThe headers that most users want:\n\n"
        f"| header | what it has |\n|---|---|\n{rows}\nThe others: {listed}.\n"
        + "\n```{toctree}\n:hidden:\n\n" + "\n".join(header[:-2] for header in HEADERS) + "\n```\n"
    )


def concepts(header):
    """The concepts of a header, which Breathe does not support."""
    pattern = r"((?:^///.*\n)+)template <(.*)>\nconcept (\w+) = ((?:.+\n)+)"
    text = (pathlib.Path("core/include") / header).read_text()
    return "".join(
        f"````{{cpp:concept}} template<{parameters}> scb::{name}\n\n"
        + re.sub(r"^/// ?", "", comment, flags=re.M)
        + f"\n```cpp\n{wanted}```\n````\n\n"
        for comment, parameters, name, wanted in re.findall(pattern, text, flags=re.M)
    )


def main():
    texts = {manual: pathlib.Path(manual).read_text() for manual in MANUALS}
    for manual, text in texts.items():
        folder = os.path.dirname(manual)
        text = CODE_OR_LINK.sub(lambda match: linked(folder, match), text)
        if manual == "README.md":
            captions = {caption: [] for caption in (*CAPTIONS.values(), "Manuals")}
            for name in MANUALS[1:]:
                captions[CAPTIONS.get(os.path.dirname(name), "Manuals")].append(page_of(name).removesuffix(".md"))
            text += "".join(toctree(caption, pages) for caption, pages in captions.items())
            text += toctree("Generated", ["gallery", "reference/index", "reference/python"])
        write(page_of(manual), text)
    write("gallery.md", gallery(texts))
    write("reference/index.md", reference(texts["core/README.md"]))
    write("reference/python.md", python_page())
    for header in HEADERS:
        include = f"# {header}\n\n```cpp\n#include <{header}>\n```\n\n"
        declared = f"```{{doxygenfile}} {header}\n```\n"
        write("reference/" + header.replace(".h", ".md"), include + concepts(header) + declared)
    # Doxygen leaves out macros of undocumented files, and members of undocumented namespaces.
    files = "".join(f"/** @file {header} */\n" for header in ("scb/volume.h",))
    write("files.dox", files + "/** @namespace scb\n    Everything of the library. */\n")


main()
