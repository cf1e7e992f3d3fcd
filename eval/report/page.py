# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""One HTML file with everything inside: tables, plots, pictures, and on what it was measured."""
import base64
import html
import io

from PIL import Image

STYLE = """
body { font: 15px/1.45 system-ui, "DejaVu Sans", sans-serif; color: #222; max-width: 1240px;
  margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.7em; margin-bottom: .2em; }
h2 { margin-top: 2.2em; border-bottom: 2px solid #0b62b8; padding-bottom: .15em; }
h3 { margin: 1.6em 0 .5em; }
nav a { margin-right: 1.1em; }
a { color: #0b62b8; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: 12.5px; font-variant-numeric: tabular-nums; }
th, td { padding: .25em .45em; text-align: right; vertical-align: top; white-space: nowrap; }
tbody th { text-align: left; font-weight: normal; }
thead th { border-bottom: 1px solid #888; }
th.group { text-align: center; border-left: 1px solid #bbb; }
td.first, th.first { border-left: 1px solid #bbb; }
tbody tr:nth-child(even) { background: #f6f8fa; }
tr.section th { font-weight: bold; background: #e9eff6; text-align: left; }
table.wide .published { display: block; }
.published { color: #888; font-size: .85em; }
.note, .facts { color: #555; font-size: 13px; max-width: 900px; }
figure { margin: 1.2em 0; }
img { max-width: 100%; width: 900px; height: auto; }
img.wide { width: 1100px; }
figcaption { color: #555; font-size: 13px; }
.warning { background: #fff4e0; border-left: 4px solid #e8820c; padding: .5em 1em; }
"""


def image(path, faults, caption="", wide=False):
    """A picture, inside the page; a wide one, of points, as JPEG: a fifth of its size. One that cannot be read is
    left out and named in the list faults."""
    kind, packed = "jpeg" if wide else "png", io.BytesIO()
    try:
        with open(path, "rb") as file:
            content = file.read()
        pixels = Image.open(io.BytesIO(content)).convert("RGB")  # reads all of it: a cut-off picture ends here
    except (OSError, SyntaxError, ValueError) as error:
        faults.append("The picture %s cannot be read (%s) and is left out; without the file it is drawn anew."
                      % (path, error))
        return ""
    if wide:
        pixels.save(packed, "JPEG", quality=88)
        content = packed.getvalue()
    return ('<figure><img%s alt="%s" src="data:image/%s;base64,%s"><figcaption>%s</figcaption></figure>'
            % (' class="wide"' if wide else "", html.escape(caption or "plot"), kind,
               base64.b64encode(content).decode(), html.escape(caption)))


def warning(text):
    return '<p class="warning">%s</p>' % html.escape(text)


def facts(rows):
    """Name and value, line by line."""
    return '<p class="facts">%s</p>' % "<br>".join(
        "<b>%s</b> %s" % (html.escape(name), html.escape(value)) for name, value in rows if value)


def page(title, head, chapters):
    """The whole page. chapters: (heading, HTML); those without content are left out."""
    filled = [(name, body) for name, body in chapters if body]
    links = "".join('<a href="#c%d">%s</a>' % (i, html.escape(name)) for i, (name, _) in enumerate(filled))
    body = "".join('<h2 id="c%d">%s</h2>%s' % (i, html.escape(name), text) for i, (name, text) in enumerate(filled))
    return ('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width, initial-scale=1">'
            '<title>%s</title><style>%s</style></head>'
            '<body><h1>%s</h1>%s<nav>%s</nav>%s</body></html>\n'
            % (html.escape(title), STYLE, html.escape(title), head, links, body))
