#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives the polhode binary into every diagnostic.   usage: diagnostics_test.py POLHODE"""
import concurrent.futures, functools, json, os, re, resource, shlex, shutil, subprocess, unittest

import diagnostics as rows
from case import EXE, Case, environment
from patience import within

SAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../golden/data/results.json')
QUICK = ('--effort', 'quick', '--experiments', 'casimir', '--schemes', 'heun', '--threads', '1')


class Said(Case):
    def setUp(self):
        super().setUp()
        rows.files_for(self.folder.name, SAMPLE)
        self.baselines = os.path.join(self.cache, 'baselines')
        os.makedirs(os.path.join(self.baselines, 'old/good'))
        shutil.copy(SAMPLE, os.path.join(self.baselines, 'old/good'))
        self.left = self.left_behind()

    def write(self, name, data):
        with open(os.path.join(self.folder.name, name), 'wb') as f: f.write(data if isinstance(data, bytes) else data.encode())
        return name

    def hold(self, table):
        """Each command line to its words, some at a time; none of them leaves anything behind."""
        run = functools.partial(self.run_it, POLHODE_BASELINES=self.baselines)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool: runs = list(pool.map(lambda row: run(*(shlex.split(row[0]) if isinstance(row[0], str) else row[0])), table))
        for (command, words, *code), (rc, out, err) in zip(table, runs):
            with self.subTest(command=command):
                self.assertEqual((rc, out), (code[0] if code else 2, ''), err)
                self.assertRegex(err, r'\Apolhode: ' + re.escape(words).replace(re.escape('...'), '[^\n]*') + r'\n\Z')
        self.assertEqual(self.left_behind(), self.left)


class Arguments(Said):
    def test_the_command_line(self): self.hold(rows.COMMAND_LINE)
    def test_verify(self): self.hold(rows.VERIFY)
    def test_simulate(self): self.hold(rows.SIMULATIONS)
    def test_reference(self): self.hold(rows.REFERENCES)
    def test_select(self): self.hold(rows.SELECTIONS)
    def test_compare(self): self.hold(rows.COMPARISONS)
    def test_check(self): self.hold(rows.CHECKS)
    def test_reproduce(self): self.hold(rows.REPRODUCTIONS)
    def test_output_folders(self): self.hold(rows.FOLDERS)

    def test_scenes_that_no_double_holds(self):
        table = []
        for i, (line, words) in enumerate(rows.EXTREMES):
            key = line.split(' = ')[0]
            kept = [one for one in rows.BODY.format('far', .5, '[0.6, 0.48, 0.64]').splitlines() if not one.startswith(key)]
            table.append((f'reference {self.write(f"far{i}.toml", chr(10).join([*kept, line]))} --quantity gap', words))
        self.hold(table)

    def test_no_more_files(self):
        few = lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (5, 5))
        p = subprocess.run([EXE, 'verify', '--with', 'true'], capture_output=True, text=True, preexec_fn=few, cwd=self.folder.name, env=environment(), timeout=within(60))
        self.assertEqual((p.returncode, p.stdout, p.stderr), (2, '', "polhode: --with 'true': no pipe: Too many open files\n"))

    def test_no_place_for_baselines(self):
        rc, out, err = self.run_it('verify', '--baseline', 'x', POLHODE_BASELINES='', XDG_DATA_HOME='', HOME='')
        self.assertEqual((rc, out, err), (2, '', 'polhode: --baseline: no place for baselines; accepted: POLHODE_BASELINES or HOME set\n'))


class Contents(Said):
    def changed(self, path, value, name):
        with open(SAMPLE, encoding='utf-8') as f: results = json.load(f)
        at = functools.reduce(lambda one, key: one[key], path[:-1], results)
        at[path[-1]] = value
        if value is None: del at[path[-1]]
        return self.write(name, json.dumps(results))

    def test_results_of_two_scenes(self):
        hostile = '</script><img src=x onerror=alert(1)>'
        words = f"the two results are of different scenes ({{}} differs: '{hostile}' and '{hostile}'); accepted: two results of one scene"
        table = [(f'compare good.json {self.changed(("scene", *path), value, f"other{i}.json")}', words.format(key)) for i, (path, value, key) in enumerate(rows.SCENES)]
        self.left = self.left_behind()
        self.hold(table)

    def test_results(self):
        table = [(f'compare good.json {self.changed(path, value, f"bad{i}.json")}', f'bad{i}.json: results: {words}') for i, (path, value, words) in enumerate(rows.RESULTS)]
        for name, text, words in (('word.json', 'results', 'not JSON, or cut short, at byte 1 of 7'), ('list.json', '[1, 2]', 'the document: expected an object'), ('deep.json', 100_000 * '[', 'not JSON, or cut short, at byte 100001 of 100000'),
                                  ('huge.json', '{"schema": 1e400}', 'holds a number that is too large for a double'), ('bytes.json', b'"\xff"', 'not JSON, or cut short, at byte 2 of 3')):
            table.append((f'compare good.json {self.write(name, text)}', f'{name}: results: {words}'))
        self.left = self.left_behind()
        self.hold(table)

    def test_recorded_tables(self):
        table = [(f'check {self.write(f"{i}.csv", text)} --scene paper', f'{i}.csv{words}') for i, (text, words) in enumerate(rows.TABLES)]
        self.left = self.left_behind()
        self.hold(table)

    def test_recorded_arrays(self):
        table = [(f'check {self.write(f"{i}.npy", data)} --scene paper --dt 1', f'{i}.npy: {words}') for i, (data, words) in enumerate(rows.ARRAYS)]
        self.left = self.left_behind()
        self.hold(table)

    def test_commands_that_are_no_integrators(self):
        greeting = [(f"printf '{line}\\n'", words) for line, words in rows.GREETINGS]
        self.hold([(('verify', 'good.toml', '--with', command, *QUICK), f"--with '{command.strip()}': {words}") for command, words in (*rows.WITH, *greeting)])


if __name__ == '__main__':
    unittest.main()
