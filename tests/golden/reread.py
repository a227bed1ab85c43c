#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads a report folder again with parsers that share nothing with the writers, and compares the formats.

    reread.py PROGRAM      runs PROGRAM OUT and reads what it wrote
    reread.py --folder DIR reads a report folder (or a folder of report folders) that is there already
"""
import csv
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

from markup import Page, unpacked

FILES = {'results.json', 'digest.json', 'measurements.csv', 'verdicts.csv', 'report.html', 'report.md', 'junit.xml'}
MEASURED = 'experiment,scheme,quantity,observable,dt,value,low,high,unit,method,at'.split(',')
JUDGED = 'experiment,scheme,claim,expected,estimate,low,high,verdict,reason'.split(',')
KINDS = ('holds', 'refuted', 'inconclusive', 'not tried', 'skipped')
LEFT_OUT = ('not tried', 'skipped')


def refuse_constant(name):
    raise ValueError(f'{name} in results.json')


def number(text):
    return None if text == '' else float(text)


def same(a, b):
    return a is None and b is None or a is not None and b is not None and float(a).hex() == float(b).hex()


def rows_of(path, columns):
    with open(path, newline='', encoding='utf-8') as file:
        rows = list(csv.reader(file, strict=True))
    assert rows[0] == columns, rows[0]
    assert all(len(row) == len(columns) for row in rows), path
    return [dict(zip(columns, row)) for row in rows[1:]]


def coordinates(text):
    """"theta=8; dt=0.125" by name."""
    return {name: float(value) for name, value in (part.rsplit('=', 1) for part in text.split('; ') if part)}


def as_rows(measurements):
    """The measurements as the table shows them: the place as numbers by name, and dt once more."""
    places = [{c['name']: c['value'] for c in m['at']} for m in measurements]
    return [m | {'at': place, 'dt': place.get('dt')} for m, place in zip(measurements, places)]


def compare_tables(results, folder):
    measured, judged = rows_of(f'{folder}/measurements.csv', MEASURED), rows_of(f'{folder}/verdicts.csv', JUDGED)
    assert len(measured) == len(results['measurements']) and len(judged) == len(results['verdicts'])
    for table, records, numbers in ((measured, as_rows(results['measurements']), ('dt', 'value', 'low', 'high')),
                                    (judged, results['verdicts'], ('expected', 'estimate', 'low', 'high'))):
        for row, record in zip(table, records):
            for key, text in row.items():
                if key in numbers:
                    value = number(text)
                    assert value is None or math.isfinite(value), (key, text)
                    assert same(value, record[key]), (key, text, record[key])
                else:
                    found = coordinates(text) if key == 'at' else text
                    assert found == record[key], (key, text, record[key])


def compare_status(results):
    for record in results['measurements']:
        assert record['value'] is not None or record['status'] != 'ok', record
    for record in results['fits']:
        assert record['order'] is not None or record['status'] != 'ok', record


def compare_plots(results):
    """Every plot has a name of its own and names series that were measured."""
    identity = ('scheme', 'quantity', 'observable', 'over')
    known = {(m['experiment'], *(m[key] for key in identity)) for m in results['measurements']}
    ids = [plot['id'] for plot in results['plots']]
    assert len(set(ids)) == len(ids), ids
    for plot in results['plots']:
        assert plot['lines'], plot
        for series in [line['series'] for line in plot['lines']] + plot.get('levels', []):
            assert (plot['experiment'], *(series[key] for key in identity)) in known, series


def compare_junit(results, folder):
    root = xml.parse(f'{folder}/junit.xml').getroot()
    cases = root.findall('./testsuite/testcase')
    expected = {kind: sum(v['verdict'] == kind for v in results['verdicts']) for kind in KINDS}
    failures = [f for case in cases for f in case.findall('failure')]
    skipped = [s for case in cases for s in case.findall('skipped')]
    assert len(cases) == len(results['verdicts']) == int(root.get('tests'))
    assert sum(f.get('type') == 'refuted' for f in failures) == expected['refuted']
    assert sum(f.get('type') == 'inconclusive' for f in failures) == expected['inconclusive']
    assert len(failures) == int(root.get('failures')) and len(skipped) == sum(expected[kind] for kind in LEFT_OUT) == int(root.get('skipped'))
    names = sorted((v['experiment'] + '.' + v['scheme'], v['claim']) for v in results['verdicts'])
    assert sorted((case.get('classname'), case.get('name')) for case in cases) == names
    for suite in root.findall('testsuite'):
        assert int(suite.get('tests')) == len(suite.findall('testcase'))


def compare_page(results, folder):
    """The page's markup, and what it carries; tests/browser looks at what it makes of that."""
    with open(f'{folder}/report.html', encoding='utf-8') as file:
        source = file.read()
    page = Page()
    page.feed(source)
    page.close()
    assert not page.open, page.open
    assert page.title == results['scene']['name'] + ' \u00b7 polhode', page.title
    assert len(page.data) == 1, len(page.data)
    assert json.loads(unpacked(page.data[0]), parse_constant=refuse_constant) == results


def compare_markdown(results, folder):
    with open(f'{folder}/report.md', encoding='utf-8') as file:
        text = file.read()
    assert len(text.encode()) < 1_000_000
    found = re.search(r'(\d+) claims?: (\d+) holds?, (\d+) (?:is|are) refuted, (\d+) (?:is|are) inconclusive, (\d+) (?:is|are) not tried, (\d+) (?:is|are) skipped\.', text)
    counts = [len(results['verdicts'])] + [sum(v['verdict'] == kind for v in results['verdicts']) for kind in KINDS]
    assert found and [int(n) for n in found.groups()] == counts, (found and found.groups(), counts)
    assert '<' not in text and text.index(found.group()) < 600
    for table in re.findall(r'(?:^\|.*\n)+', text, re.M):  # as many cells in every row
        widths = {len(re.findall(r'(?<!\\)\|', line)) for line in table.splitlines()}
        assert len(widths) == 1, table


def reread(folder):
    assert set(os.listdir(folder)) == FILES, os.listdir(folder)
    with open(f'{folder}/results.json', encoding='utf-8') as file:
        results = json.load(file, parse_constant=refuse_constant)
    assert results['schema'] == {'name': 'polhode-results', 'version': 2}
    compare_status(results)
    compare_plots(results)
    compare_tables(results, folder)
    compare_junit(results, folder)
    compare_page(results, folder)
    compare_markdown(results, folder)
    print(f'{folder}: {len(results["measurements"])} measurements, {len(results["verdicts"])} verdicts agree in all formats')


def reread_all(out):
    if 'results.json' in os.listdir(out):
        return reread(out)
    folders = sorted(os.listdir(out))
    assert folders and not any(name.startswith('.') for name in folders), folders
    for name in folders:
        reread(os.path.join(out, name))


def main():
    if len(sys.argv) == 3 and sys.argv[1] == '--folder':
        return reread_all(sys.argv[2])
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as scratch:
        subprocess.run([sys.argv[1], f'{scratch}/out'], check=True)
        assert os.listdir(scratch) == ['out'], os.listdir(scratch)
        reread_all(f'{scratch}/out')


if __name__ == '__main__':
    main()
