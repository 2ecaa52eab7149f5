"""mend.py XML: removes parts of Doxygen's files that Sphinx cannot read or would repeat: initial values that are lambdas or name
their members, deduction guides, private members, typedefs that give a C struct its own name, and the file of a struct."""

import pathlib
import sys
from xml.etree import ElementTree


def is_left_out(member):
    name, type_ = member.findtext("name"), "".join(member.find("type").itertext()) if member.find("type") is not None else ""
    guide = "->" in (member.findtext("argsstring") or "")
    own_name = member.get("kind") == "typedef" and type_.split()[-1:] == [name]
    return guide or own_name


for path in pathlib.Path(sys.argv[1]).glob("*.xml"):
    tree = ElementTree.parse(path)
    for section in tree.iter("sectiondef"):
        for member in section.findall("memberdef"):
            value = member.find("initializer")
            if is_left_out(member):
                section.remove(member)
            elif value is not None and "".join(value.itertext()).lstrip("= ").startswith(("[]", "{.")):
                member.remove(value)
    for parent in tree.iter("compounddef"):
        for include in parent.findall("includes"):
            parent.remove(include)
        for section in parent.findall("sectiondef"):
            if section.find("memberdef") is None or section.get("kind").startswith("private"):
                parent.remove(section)
    tree.write(path)
