# SPDX-License-Identifier: Apache-2.0
"""docs/verify-in-python.md and .ipynb run as they stand, each from top to bottom in an empty folder."""
import ast, contextlib, io, json, os, re, sys, unittest

import numpy as np

sys.path.insert(0, os.path.dirname(__file__))
import case

DOCS = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'docs', 'verify-in-python')


def last_value(cell, names):
    """What a notebook shows of a cell: the value of its last expression, as HTML where it has that."""
    tree = ast.parse(cell)
    last = ast.Expression(tree.body.pop().value) if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, '<cell>', 'exec'), names)
    value = eval(compile(last, '<cell>', 'eval'), names) if last else None
    return value._repr_html_() if hasattr(value, '_repr_html_') else repr(value)


class Docs(case.Case):
    def setUp(self):
        super().setUp()
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)

    def test_guide(self):
        with open(DOCS + '.md', encoding='utf-8') as f: blocks = re.findall(r'^```python\n(.*?)^```', f.read(), re.M | re.S)
        self.assertGreater(len(blocks), 6)
        out, names = io.StringIO(), {}
        with contextlib.redirect_stdout(out):
            for block in blocks: exec(compile(block, '<block>', 'exec'), names)
        self.assertIn('read-only', out.getvalue())
        self.assertTrue(os.path.exists('report/paper/report.html'))

    def test_notebook(self):
        with open(DOCS + '.ipynb', encoding='utf-8') as f: book = json.load(f)
        self.assertEqual(book['nbformat'], 4)
        self.assertEqual([c['outputs'] for c in book['cells'] if c['cell_type'] == 'code' and c['outputs']], [])
        names, shown_by = {}, []
        for cell in book['cells']:
            if cell['cell_type'] == 'code': shown_by.append(last_value(''.join(cell['source']), names))
        board = shown_by[3]
        self.assertIn('<table>', board)
        self.assertIn('refuted', board)
        self.assertEqual({row['scheme'] for row in names['report'].refuted}, {'too_hot'})
        self.assertEqual(case.verdicts(names['report'], 'my_lie_heun'), case.verdicts(names['report'], 'lie_heun'))
        error = lambda scheme: [row['value'] for row in names['report'].measurements if row['scheme'] == scheme and row['quantity'] == 'error']
        np.testing.assert_allclose(error('my_lie_heun'), error('lie_heun'), rtol=1e-9)


if __name__ == '__main__':
    unittest.main()
