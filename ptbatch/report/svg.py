"""A figure as SVG that stands in a page of HTML beside others."""

import re
from io import BytesIO
from typing import Any
from xml.etree import ElementTree

from markupsafe import Markup
from matplotlib import rc_context
from matplotlib.figure import Figure

from ptbatch.plots import style

SVG, LINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}href"
LETTERS: Any = {"svg.fonttype": "none"}  # text stays text: it can be searched, and read aloud
REFERENCE = re.compile(r"(?:(?<=^)|(?<=url\())#([^)]+)")  # in an attribute
DROPPED = ("metadata", "style")  # a style of one figure would be one of the whole page
LIKE_DEJAVU = "'DejaVu Sans', Verdana, sans-serif"  # of the same width, where it is not installed


def inline(figure: Figure, prefix: str, title: str) -> Markup:
    """The figure as an element of HTML.

    prefix: begins every id in it, so that it may use no definition of another figure. title: read in place of
    it. No name that a user typed is left in an id.
    """
    root = ElementTree.fromstring(_svg(figure))
    _number_ids(root, prefix)
    for parent in root.iter():
        for child in [c for c in parent if c.tag.removeprefix(SVG) in DROPPED]:
            parent.remove(child)
    size = {name: root.attrib.pop(name) for name in ("width", "height")}
    root.set("style", f"aspect-ratio: {_points(size['width']):g} / {_points(size['height']):g}")
    root.set("role", "img")
    root.set("aria-label", title)
    for element in root.iter():
        _plain(element)
    return Markup(ElementTree.tostring(root, encoding="unicode"))


def _svg(figure: Figure) -> bytes:
    file = BytesIO()
    with rc_context(style.RC | LETTERS):
        figure.savefig(file, format="svg", metadata={"Date": None})
    return file.getvalue()


def _points(size: str) -> float:
    return float(size.removesuffix("pt"))


def _number_ids(root: ElementTree.Element, prefix: str) -> None:
    """Give every element that is referred to an id of its own, and take the others away."""
    fresh: dict[str, str] = {}

    def renamed(match: re.Match[str]) -> str:
        return "#" + fresh.setdefault(match[1], f"{prefix}-{len(fresh) + 1}")

    for element in root.iter():
        for name, value in element.attrib.items():
            if name != "id":
                element.set(name, REFERENCE.sub(renamed, value))
    for element in root.iter():
        mine = element.attrib.pop("id", None)
        if mine in fresh:
            element.set("id", fresh[mine])


def _plain(element: ElementTree.Element) -> None:
    """Names as HTML has them, which knows the namespaces itself; a type of similar width for that of the
    figures."""
    element.tag = element.tag.removeprefix(SVG)
    if LINK in element.attrib:
        element.set("href", element.attrib.pop(LINK))
    if element.tag == "text":
        look = element.get("style", "")
        element.set("style", look.replace("'DejaVu Sans'", LIKE_DEJAVU).replace(", sans-serif, ", ", "))
