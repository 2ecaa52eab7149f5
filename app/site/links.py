"""links.py SITE: checks that all links, pictures, files and headings that pages of the site refer to exist. Lists external
addresses, but opens none of them."""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value is not None:
                self.links.append(value)
            elif name in ("id", "name"):
                self.anchors.add(value)


site = pathlib.Path(sys.argv[1]).resolve()
pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
outside, count, failures = {}, 0, 0
for path, page in pages.items():
    for link in page.links:
        url = urllib.parse.urlsplit(link)
        if url.scheme or url.netloc:
            if url.scheme != "data":
                outside.setdefault(link, path)
            continue
        count += 1
        there = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
        anchor = urllib.parse.unquote(url.fragment)
        if not there.is_file() or (anchor and there in pages and anchor not in pages[there].anchors):
            print(f"FAILED: {path.relative_to(site)}: {link} is not there.")
            failures += 1
for link, path in sorted(outside.items()):
    print(f"not asked: {link} ({path.relative_to(site)})")
print(f"{len(pages)} pages, {count} links, {len(outside)} addresses outside, {failures} failures")
sys.exit(1 if failures or not count else 0)
