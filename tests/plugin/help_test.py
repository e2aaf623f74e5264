# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of help that the "?" of the property panel shows. The folder with the file of help is
in the environment variable WINDING_HELP."""
import html.parser
import os
import pathlib
import sqlite3
import unittest
import zlib
from xml.etree import ElementTree

from paraview import servermanager

from support import run_tests

HELP = pathlib.Path(os.environ["WINDING_HELP"])
PLUGIN = pathlib.Path(__file__).resolve().parents[2] / "paraview-plugin"


def files_of_help():
    """All files in ParaView's file of help by name; it is a database of what Qt has compressed."""
    database = sqlite3.connect(f"file:{HELP / 'WindingNumbers.qch'}?mode=ro", uri=True)
    query = ("SELECT names.Name, data.Data FROM FileNameTable AS names "
             "JOIN FileDataTable AS data ON names.FileId = data.Id WHERE data.Data NOT NULL")
    files = {name: zlib.decompress(data[4:]) for name, data in database.execute(query)}
    database.close()
    return files


def filters():
    menu = ElementTree.parse(PLUGIN / "Menu.xml")
    return [proxy.get("name") for proxy in menu.iter("Proxy")]


def properties_of(name):
    """The properties that the panel of a filter can show or scripts can ask for."""
    proxy = servermanager.ProxyManager().NewProxy("filters", name)
    iterator = proxy.NewPropertyIterator()
    shown, reported = set(), set()
    while not iterator.IsAtEnd():
        smproperty = iterator.GetProperty()
        if smproperty.GetInformationOnly():
            reported.add(iterator.GetKey())
        elif smproperty.GetPanelVisibility() != "never":
            shown.add(iterator.GetKey())
        iterator.Next()
    return shown, reported


class Page(html.parser.HTMLParser):
    """The text of a page, the names of properties in it, and its pictures."""

    def __init__(self, text):
        super().__init__()
        self.open_tags, self.texts, self.names, self.pictures = [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag == "img":
            self.pictures.append(dict(attrs)["src"])
        elif tag not in ("br", "meta"):
            self.open_tags.append(tag)

    def handle_endtag(self, tag):
        if tag not in ("br", "meta", "img"):
            if self.open_tags.pop() != tag:
                raise AssertionError(f"{tag} ends where something else is open")

    def handle_data(self, data):
        (self.names if self.open_tags[-1:] == ["code"] else self.texts).append(data)


class TestHelp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = files_of_help()

    def page(self, name):
        return Page(self.files[name + ".html"].decode("utf-8"))

    def test_pages_have_all_properties_once(self):
        for name in filters():
            with self.subTest(name):
                shown, reported = properties_of(name)
                names = self.page("filters." + name).names
                self.assertEqual(sorted(names), sorted(shown | reported))
        for name in ("WindingNumberField", "WindingNumberSurface"):
            expected = {"Resolution", "Method", "Tolerance", "EstimateNormals"}
            self.assertLessEqual(expected, set(self.page("filters." + name).names))

    def test_pages_speak_of_nothing_that_has_no_effect(self):
        for name, data in self.files.items():
            if name.startswith(("filters.", "sources.")):
                with self.subTest(name):
                    text = data.decode("utf-8")
                    self.assertNotIn("no effect", text)
                    self.assertNotIn("**", text)

    def test_pages_have_a_picture(self):
        for name in filters():
            with self.subTest(name):
                self.assertEqual(self.page("filters." + name).pictures, [name + ".png"])
                picture = self.files[name + ".png"]
                self.assertEqual(picture, (PLUGIN / "help" / f"{name}.png").read_bytes())
                self.assertTrue(picture.startswith(b"\x89PNG"))

    def test_readers_have_pages(self):
        for name, more in (("GeomviewOFFReader", []), ("SurfaceMeshReader", []),
                           ("OrientedPointsReader", ["Columns"]),
                           ("PointTableReader",
                            ["Columns", "ReadNormalsAndAreas", "ReadAllColumns"])):
            self.assertEqual(self.page("sources." + name).names, ["FileName", *more])


if __name__ == "__main__":
    run_tests()
