# SPDX-FileCopyrightText: 2026 The primitect developers
# SPDX-License-Identifier: BSD-3-Clause
"""A table once, written as CSV, Markdown and HTML."""
import csv
import html
from collections import namedtuple

# groups: [(heading, number of columns)] above columns: [heading]; rows: [(label, [Cell])], None for the cells of a
# section's heading.
Table = namedtuple("Table", "key title note groups columns rows")
WIDE_TABLE = 12  # columns; with more, the paper's figures go below ours on the page
Cell = namedtuple("Cell", "value digits published best seeds", defaults=(frozenset(),))


def cell(value, digits=1, published=None):
    """One figure; value None: nothing to say. published: the paper's own figure."""
    return Cell(value, digits, published, False)


def measured_on(cells, lines):
    """The cells with the seeds of the clouds that they are about."""
    seeds = frozenset(line["seed"] for line in lines)
    return [c._replace(seeds=seeds) for c in cells]


def seeds_of(table):
    """The seeds of all its cells."""
    return frozenset().union(*(c.seeds for _, cells in table.rows for c in cells or ()))


def seeds_text(seeds):
    """"100, 1000 to 1074"."""
    runs = []
    for seed in sorted(seeds):
        if runs and seed == runs[-1][1] + 1:
            runs[-1][1] = seed
        else:
            runs.append([seed, seed])
    return ", ".join("%d" % first if first == last else "%d to %d" % (first, last) for first, last in runs) or "none"


def clouds_text(count):
    return "1 cloud" if count == 1 else "%d clouds" % count


def shown(number, digits):
    """As it is printed everywhere."""
    return "–" if number is None else str(number) if isinstance(number, str) else "%.*f" % (digits, number)


def mark_best(cells, higher):
    """The cells with the best of them marked, all that print alike. Only those on the largest set of clouds take part:
    fewer clouds may be easier ones. Texts and missing ones do not, either."""
    largest = max((c.seeds for c in cells), key=len, default=frozenset())
    taking_part = [isinstance(c.value, (int, float)) and c.seeds == largest for c in cells]
    numbers = [c.value for c, takes_part in zip(cells, taking_part) if takes_part]
    best = max(numbers, default=0) if higher else min(numbers, default=0)
    if len(numbers) < 2 or (higher and best == 0):  # nobody is good who has nothing
        return cells
    return [c._replace(best=takes_part and shown(c.value, c.digits) == shown(best, c.digits))
            for c, takes_part in zip(cells, taking_part)]


def mark_columns(rows, higher_of_column, skip=("truth handed in",)):
    """Rows with the best of each column marked; None in higher_of_column: no best. Rows named in skip stay out."""
    taking_part = [i for i, (label, cells) in enumerate(rows) if cells and label not in skip]
    rows = [(label, list(cells) if cells else cells) for label, cells in rows]
    for column, higher in enumerate(higher_of_column):
        if higher is None:
            continue
        for i, marked in zip(taking_part, mark_best([rows[i][1][column] for i in taking_part], higher)):
            rows[i][1][column] = marked
    return rows


def headings(table):
    """One heading a column, with its group's in front."""
    names = [name for name, span in table.groups for _ in range(span)]
    return [" ".join(filter(None, pair)) for pair in zip(names, table.columns)]


def head_lines(environment, seeds):
    """What stands above each CSV file."""
    return "# cpu: %s date: %s commit: %s seeds: %s\n" % (environment["cpu"], environment["date"],
                                                          environment["commit"], seeds)


def write_csv(table, path, head):
    """The table with full digits; a column for the paper's figure behind each that has one."""
    names = headings(table)
    rows = [(label, cells) for label, cells in table.rows if cells]
    published = [any(cells[i].published is not None for _, cells in rows) for i in range(len(names))]
    section = ""
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write(head + "# %s\n" % table.title)
        writer = csv.writer(file, lineterminator="\n")
        columns = []
        for name, has in zip(names, published):
            columns += [name, name + " (paper)"] if has else [name]
        writer.writerow(["section", "row"] + columns)
        for label, cells in table.rows:
            if cells is None:
                section = label
                continue
            figures = []
            for one, has in zip(cells, published):
                figures += [csv_text(one.value)] + ([csv_text(one.published)] if has else [])
            writer.writerow([section, label] + figures)


def csv_text(value):
    return "" if value is None else value if isinstance(value, str) else "%.6g" % value


def markdown(table):
    """As text for a README; the paper's figures in brackets."""
    lines = ["### " + table.title, "", table.note, "", "| | " + " | ".join(headings(table)) + " |",
             "|---|" + "---:|" * len(table.columns)]
    for label, cells in table.rows:
        if cells is None:
            lines.append("| **%s** |" % label + " |" * len(table.columns))
            continue
        lines.append("| %s | " % label + " | ".join(markdown_cell(one) for one in cells) + " |")
    return "\n".join(lines) + "\n"


def markdown_cell(one):
    text = shown(one.value, one.digits)
    text = "**%s**" % text if one.best else text
    return text if one.published is None else "%s [%s]" % (text, published_text(one))


def published_text(one):
    """The paper's figure with the digits that it is printed with there."""
    return shown(one.published, 0 if isinstance(one.published, int) else one.digits)


def html_table(table):
    """A figure element with heading, table and note."""
    parts = ['<section class="table"><h3>%s</h3><div class="scroll"><table%s><thead>'
             % (html.escape(table.title), ' class="wide"' if len(table.columns) > WIDE_TABLE else "")]
    if any(name for name, _ in table.groups):
        parts.append("<tr><th></th>" + "".join('<th colspan="%d" class="group">%s</th>' % (span, html.escape(name))
                                               for name, span in table.groups) + "</tr>")
    starts = group_starts(table)
    parts.append("<tr><th></th>" + "".join('<th%s>%s</th>' % (starts[i], html.escape(name))
                                           for i, name in enumerate(table.columns)) + "</tr></thead><tbody>")
    for label, cells in table.rows:
        if cells is None:
            parts.append('<tr class="section"><th colspan="%d">%s</th></tr>'
                         % (len(table.columns) + 1, html.escape(label)))
        else:
            parts.append("<tr><th>%s</th>" % html.escape(label) + "".join(
                "<td%s>%s</td>" % (starts[i], html_cell(one)) for i, one in enumerate(cells)) + "</tr>")
    return "".join(parts) + '</tbody></table></div><p class="note">%s</p></section>' % html.escape(table.note)


def group_starts(table):
    """The attribute of each column: the first of a group gets a line on its left."""
    attributes = []
    for _, span in table.groups:
        attributes += [' class="first"'] + [""] * (span - 1)
    return attributes


def html_cell(one):
    text = html.escape(shown(one.value, one.digits))
    text = "<b>%s</b>" % text if one.best else text
    return text if one.published is None else '%s <span class="published">[%s]</span>' % (text, published_text(one))
