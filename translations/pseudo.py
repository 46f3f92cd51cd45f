#!/usr/bin/env python3
"""Makes the pseudo-language of the tests from a .ts file: every source string, accented, a third longer, in brackets.
A text on the screen without brackets was never meant to be translated; one cut off had too little room.
Usage: pseudo.py IN.ts OUT.ts"""
import re
import sys
import xml.etree.ElementTree as tree

ACCENTS = str.maketrans("aeiounycAEIOUNYC", "àéîöüñýçÀÉÎÖÜÑÝÇ")
# What must stay as it is: %1, %n, %L1, HTML tags and entities, and the mnemonic's ampersand.
KEPT = re.compile(r"(%L?\d+|%n|<[^>]*>|&[a-z]+;|\*\.\w+)")


def pseudo(text):
    parts = KEPT.split(text)
    body = "".join(p if KEPT.fullmatch(p) else p.translate(ACCENTS) for p in parts)
    return "[" + body + "·" * max(1, len(text) // 3) + "]"


def main(source, target):
    document = tree.parse(source)
    root = document.getroot()
    root.set("language", "en_US")
    root.attrib.pop("sourcelanguage", None)
    for context in root.iter("context"):
        for message in list(context.iter("message")):
            translation = message.find("translation")
            if translation.get("type") in ("vanished", "obsolete"):
                context.remove(message)
                continue
            translation.attrib.pop("type", None)
            text = pseudo(message.findtext("source"))
            if message.get("numerus") == "yes":
                translation.clear()
                for _ in range(2):
                    tree.SubElement(translation, "numerusform").text = text
            else:
                translation.clear()
                translation.text = text
    document.write(target, encoding="utf-8", xml_declaration=True)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
