# SPDX-License-Identifier: Apache-2.0
"""The markup of a report page, read strictly, and what the page carries."""
import base64
import re
import zlib
from html.parser import HTMLParser

VOID = {'meta', 'br', 'img', 'link', 'hr', 'input'}
ATTRIBUTES_THAT_FETCH = {'src', 'href', 'srcset', 'action', 'data', 'xlink:href', 'poster', 'background'}


def unpacked(text):
    """A text of the page as it was before it was packed."""
    return zlib.decompress(base64.b64decode(text, validate=True)).decode()


def carried(page):
    """The texts that a page carries, by name, unpacked."""
    packed = re.findall(r'<script type="application/zlib" id="(\w+)">([^<]*)</script>', page)
    return {name: unpacked(text) for name, text in packed if text}


class Page(HTMLParser):
    """Keeps the title and the data, and insists that every element is closed in order and none asks for a file."""

    def __init__(self):
        super().__init__()
        self.open, self.title, self.data, self.in_data = [], '', [], False

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        assert tag not in ('iframe', 'object', 'embed', 'img', 'link', 'base'), f'<{tag}> in the page'
        for name, value in attributes.items():
            assert not name.startswith('on'), f'{name} in <{tag}>'
            assert name not in ATTRIBUTES_THAT_FETCH or value.startswith('#'), f'{name}={value}'
        self.in_data = tag == 'script' and attributes.get('id') == 'results'
        if self.in_data:
            assert attributes['type'] == 'application/zlib'
            self.data.append('')
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f'</{tag}> closes {self.open[-3:]}'
        self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1] == 'title':
            self.title += data
        elif self.open and self.open[-1] == 'script' and self.in_data:
            self.data[-1] += data
