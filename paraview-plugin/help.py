# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the pages that the "?" of ParaView's property panels shows, one for each filter or reader.

    python3 help.py <folder to write to> <file.xml…>

ParaView's own pages leave out what a proxy inherits from another one, which for these filters is
most of their properties. Here a page has all of them under the headings of the panel, and the
picture of its filter from the folder help.
"""
import html
import pathlib
import re
import sys
from xml.etree import ElementTree

PICTURES = pathlib.Path(__file__).resolve().parent / "help"

SETTABLE_COLUMNS = {"Property": "22%", "Description": "48%", "Default": "12%", "Values": "18%"}
REPORTED_COLUMNS = {"Property": "22%", "Description": "78%"}


def panel_label(element):
    """The label that ParaView gives a property: that of its XML, or its name in words."""
    words = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", element.get("name"))
    return element.get("label", words)


def chain(proxy, proxies):
    """The proxies whose properties a proxy has, its most general base first."""
    base = proxies.get((proxy.get("base_proxygroup"), proxy.get("base_proxyname")))
    return (chain(base, proxies) if base is not None else []) + [proxy]


def properties_of(proxies):
    """All properties by name, in the order of the panel, as the last proxy that has them says."""
    found = {}
    for proxy in proxies:
        for element in proxy:
            if element.tag.endswith("Property"):
                found[element.get("name")] = element
    return found


def headings_of(proxies):
    """The heading of the panel for each property that has one."""
    return {
        member.get("name"): group.get("label")
        for proxy in proxies
        for group in proxy.iter("PropertyGroup")
        for member in group.iter("Property")
    }


def is_reported(element):
    return element.get("information_only") == "1"


def markup(text):
    """Paragraphs of HTML from the text of a Documentation, with its **bold** and *italic* words."""
    paragraphs = []
    for paragraph in re.split(r"\n\s*\n", text.strip()):
        line = html.escape(" ".join(paragraph.split()), quote=False)
        line = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", line)
        paragraphs.append(re.sub(r"\*(.+?)\*", r"<i>\1</i>", line))
    return "\n".join(f"<p>{paragraph}</p>" for paragraph in paragraphs)


def range_text(domain):
    low, high = ((domain.get(end) or "").split(" ")[0] for end in ("min", "max"))
    if low and high:
        return f"usually {low} to {high}"
    return f"at least {low}" if low else ""


def default_and_values(element):
    default = element.get("default_values", "")
    entries = {entry.get("value"): entry.get("text") for entry in element.iter("Entry")}
    if entries:
        return entries.get(default, default), "<br/>".join(map(html.escape, entries.values()))
    if element.find("BooleanDomain") is not None:
        return ("on" if default == "1" else "off"), "on, off"
    for tag in ("IntRangeDomain", "DoubleRangeDomain"):
        if element.find(tag) is not None:
            return default, range_text(element.find(tag))
    types = [data_type.get("value") for data_type in element.iter("DataType")]
    return default, "<br/>".join(types)


def row(element):
    default, values = default_and_values(element)
    label = html.escape(panel_label(element))
    cells = [
        f"<td><b>{label}</b><br/><code>{element.get('name')}</code></td>",
        f"<td>{markup(element.findtext('Documentation', ''))}</td>",
    ]
    if not is_reported(element):
        cells += [f"<td>{html.escape(default)}</td>", f"<td>{values}</td>"]
    return "<tr>" + "".join(cells) + "</tr>"


def table(title, elements, columns):
    if not elements:
        return []
    head = "".join(
        f"<th align='left' width='{width}'>{column}</th>" for column, width in columns.items())
    return [
        f"<h3>{html.escape(title)}</h3>",
        "<table width='97%' border='1' cellspacing='0' cellpadding='4'>",
        f"<tr>{head}</tr>",
        *map(row, elements),
        "</table>",
    ]


def page(proxy, proxies):
    label, name = proxy.get("label"), proxy.get("name")
    documentation = proxy.find("Documentation")
    lines = [
        "<html><head>",
        '<meta http-equiv="Content-Type" content="text/html; charset=utf-8"/>',
        f"<title>{html.escape(label)}</title></head><body>",
        f"<h2>{html.escape(label)}</h2>",
        f"<p><i>{html.escape(documentation.get('long_help'))}</i></p>",
    ]
    picture = f"{name}.png"
    if (PICTURES / picture).is_file():
        lines.append(f'<p><img src="{picture}" alt="{html.escape(label)}"/></p>')
    lines.append(markup(documentation.text))

    family = chain(proxy, proxies)
    headings = headings_of(family)
    groups = {}
    reported = []
    for element in properties_of(family).values():
        if is_reported(element):
            reported.append(element)
        elif element.get("panel_visibility") != "never" or element.get("name") == "FileName":
            groups.setdefault(headings.get(element.get("name"), "Properties"), []).append(element)
    for heading, elements in groups.items():
        lines += table(heading, elements, SETTABLE_COLUMNS)
    lines += table("What it reports", reported, REPORTED_COLUMNS)
    return "\n".join(lines + ["</body></html>", ""])


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    proxies = {}
    for path in sys.argv[2:]:
        for group in ElementTree.parse(path).iter("ProxyGroup"):
            for proxy in group:
                proxies[group.get("name"), proxy.get("name")] = proxy
    for (group, name), proxy in proxies.items():
        if group in ("filters", "sources") and proxy.find("Deprecated") is None:
            (folder / f"{group}.{name}.html").write_text(page(proxy, proxies), encoding="utf-8")
    for picture in PICTURES.glob("*.png"):
        (folder / picture.name).write_bytes(picture.read_bytes())


if __name__ == "__main__":
    main()
