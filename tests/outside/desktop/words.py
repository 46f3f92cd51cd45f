"""What the screen shows in another language, as English: tests find controls by the texts of the source in every language.

The German catalogue and the built-in exercises' titles give the pairs. A text with %1 is a pattern, and what stands in its
place is translated too.
"""
import functools
import glob
import json
import os
import re
import xml.etree.ElementTree as ET

SOURCE = os.path.abspath(__file__ + "/../../../..")
LEAST_LETTERS = 4  # of a text with %1 beside it: fewer fit too much
OF_QT = {"de": {"File name:": "Dateiname:"}}  # texts of Qt's own dialogs
LISTED = ("\n", " · ", ", ")  # between texts that one label shows, and between names
PLACE = re.compile(r"%(?:L?\d|n)")


def spaces(text):
    """As desk.plain() reads a screen."""
    return text.replace("\u00a0", " ").replace("\u202f", " ")


class English:
    """The screen is in the language of the source."""

    def meanings(self, shown):
        return [shown]

    def shown(self, text):
        return text


class Catalogue:
    """The screen is in `language`, of translations/cusp_LANGUAGE.ts."""

    def __init__(self, language):
        self.exact, self.patterns, self.titles, self.sources = {}, [], {}, set()
        for message in ET.parse(os.path.join(SOURCE, "translations", f"cusp_{language}.ts")).iter("message"):
            found = message.find("translation")
            for form in found.findall("numerusform") or [found]:
                self._add(spaces(message.findtext("source")), spaces(form.text or ""))
        for english, shown in OF_QT[language].items():
            self._add(english, shown)
        for path in glob.glob(os.path.join(SOURCE, "scenarios", "library", "*", "scenario.json")):
            with open(path, encoding="utf-8") as f:
                title = json.load(f)["title"]
            self._add_title(title["en"], title[language])
        with open(os.path.join(SOURCE, "scenarios", "blocks", "block_exercises.cpp"), encoding="utf-8") as f:
            for english, german in re.findall(r'\{"([A-Z][\w ]+)", "(\w[\w ]+)", "', f.read()):
                for level in (1, 2, 3):
                    self._add_title(f"{english}, level {level}", f"{german}, Stufe {level}")
        self.patterns.sort(key=lambda one: -one[2])
        self.meanings = functools.cache(self._meanings)

    def _add_title(self, english, shown):
        self.titles[english] = shown
        self._add(english, shown)

    def _add(self, source, translation):
        if not translation:
            return
        if source != translation:
            self.sources.add(source)
        if not PLACE.search(translation):
            meant = self.exact.setdefault(translation, [])
            if source not in meant:
                meant.append(source)
            return
        letters = sum(c.isalpha() for c in PLACE.sub("", translation))
        if letters < LEAST_LETTERS:
            return
        parts, last, order = [], 0, []
        for place in PLACE.finditer(translation):
            parts += [re.escape(translation[last:place.start()]), "(.*?)"]
            order.append(place.group())
            last = place.end()
        parts.append(re.escape(translation[last:]))
        self.patterns.append((re.compile("".join(parts), re.S), (source, order), letters))

    def _meanings(self, shown):
        """What `shown` may be in English, and last itself."""
        out = list(self.exact.get(shown, [])) or list(self.exact.get(shown.strip(), []))
        for pattern, (source, order), _ in self.patterns if len(shown) > LEAST_LETTERS else []:
            fits = pattern.fullmatch(shown)
            if not fits:
                continue
            text = source
            for place, part in zip(order, fits.groups()):
                text = text.replace(place, part if part == shown else self._meanings(part)[0])
            if text not in out:
                out.append(text)
        first, stop, rest = shown.partition(". ")
        if not out and stop:  # a band shows what happened and more in one label
            out.append(f"{self._meanings(first + '.')[0]} {self._meanings(rest)[0]}")
        for sign in LISTED:
            if not out and sign in shown:
                out.append(sign.join(self._meanings(part)[0] for part in shown.split(sign)))
        return out + [shown]

    def shown(self, text):
        """An exercise's title as the screen has it; any other text as it is."""
        return self.titles.get(text, text)


def of(language):
    return English() if language == "en" else Catalogue(language)
