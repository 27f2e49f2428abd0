# SPDX-License-Identifier: GPL-3.0-or-later
"""What MkDocs is told of pages that are also read on their own (mkdocs.yml, "hooks").

Pages may link to files of the tree outside docs/ (tools/check-links holds that they exist); the site does not hold those files, so
there such a link becomes the file's name. The page of Python and C++ links to what Doxygen made of the headers.
"""
import posixpath
import re

OUTSIDE = re.compile(r"\[([^\]]*)\]\((\.\./[^)\s]+)\)")


def on_page_markdown(markdown, page, config, files):
    folder = posixpath.dirname(page.file.src_path.replace("\\", "/"))

    def told(match):
        text, link = match.groups()
        target = posixpath.normpath(posixpath.join("docs", folder, link.partition("#")[0]))
        return match.group() if target.startswith("docs/") else f"{text} (`{target}`)"

    return OUTSIDE.sub(told, markdown)


def on_page_content(html, page, config, files):
    if page.file.src_path != "how-to/python.md":
        return html
    return html + '\n<p><a href="../api/index.html">All headers, classes and functions</a></p>\n'
