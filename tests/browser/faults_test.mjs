// SPDX-License-Identifier: Apache-2.0
// What a report must bear: files cut short, of another schema, empty, of unknown kinds, of a hundred thousand numbers.
//
//   node faults_test.mjs
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { densities, pageOf } from './pages.mjs';
import { until } from './plots.mjs';
import { atEnd, downloaded, open } from './visit.mjs';

const sample = readFileSync(new URL('../golden/data/results.json', import.meta.url));
const rich = { ...JSON.parse(sample), densities: densities() };

test('what cannot be read is said in one line', async () => {
  for (const [label, text] of [
    ['truncated', JSON.stringify(rich).slice(0, 5000)],
    ['empty', ''],
    ['array', '[1,2]'],
    ['word', 'results'],
  ]) {
    const page = await open(pageOf(text, label));
    const said = await page.textContent('main');
    assert.match(said, /^These results cannot be read/);
    assert.ok(!said.includes('\n') && said.length < 300);
    await atEnd(page);
  }
});

test('a page that was cut short or changed says so in one line', async () => {
  const url = pageOf(rich, 'changed'),
    file = fileURLToPath(url);
  for (const change of [(packed) => packed.slice(0, 1000), (packed) => packed.replace(/^../, 'AA'), () => '{}']) {
    const page = readFileSync(file, 'utf8').replace(
      /(id="results">)([^<]+)/,
      (_, place, packed) => place + change(packed),
    );
    writeFileSync(file, page);
    const opened = await open(url);
    assert.match(await opened.textContent('main'), /^These results cannot be read: not packed [^\n]*$/);
    await atEnd(opened);
    pageOf(rich, 'changed');
  }
});

test('a browser that cannot unpack says what is missing, and where it stands', async () => {
  const page = await open(pageOf(rich, 'packed'), { prepare: () => delete window.DecompressionStream });
  assert.match(await page.textContent('main'), /claims, plots and tables of this report are missing/);
  const links = await page.locator('main a').evaluateAll((all) => all.map((a) => a.getAttribute('href')));
  assert.deepEqual(links, ['report.md', 'results.json']);
  assert.equal(await page.locator('figure').count(), 0);
  await atEnd(page);
});

test('an older schema is shown with what it has', async () => {
  const old = structuredClone(rich);
  old.schema.version = 0;
  for (const name of ['fits', 'savings', 'reused', 'counters', 'densities', 'experiments']) delete old[name];
  for (const m of old.measurements) {
    delete m.used;
    delete m.status;
  }
  const page = await open(pageOf(old, 'old')),
    note = await page.textContent('.lacking');
  for (const part of ['schema version 0', 'fits', 'experiments', 'used', 'status'])
    assert.ok(note.includes(part), part);
  assert.ok((await page.locator('figure.plot').count()) > 3);
  await atEnd(page);
});

test('without descriptions of plots there are tables, and it says so', async () => {
  const { plots, ...old } = rich;
  assert.ok(plots.length > 3);
  const page = await open(pageOf({ ...old, densities: [] }, 'plotless'));
  assert.match(await page.textContent('.lacking'), /no descriptions of plots: its numbers stand in tables alone/);
  assert.equal(await page.locator('figure.plot').count(), 0);
  assert.match(await page.textContent('[id="experiment.strong"]'), /10 measurements/);
  await atEnd(page);
});

test('a run that its budget has ended does not promise a later page', async () => {
  const note = async (results, label) => {
    const page = await open(pageOf(results, label)),
      said = await page.textContent('.lacking');
    await atEnd(page);
    return said;
  };
  const cut = { ...rich, to_come: ['stability'] },
    skip = { experiment: 'stability', scheme: '', reason: 'the budget of 5 s was used up before (--budget)' };
  assert.match(await note(cut, 'growing'), /Still to come: stability\. A later page/);
  assert.match(await note({ ...cut, skipped: [...rich.skipped, skip] }, 'cut'), /ended before: stability\. What/);
});

test('nothing measured, nothing at all', async () => {
  for (const [label, results] of [
    ['none', { ...rich, measurements: [], fits: [], verdicts: [], skipped: [], densities: [], plots: [] }],
    ['bare', {}],
  ]) {
    const page = await open(pageOf(results, label));
    assert.match(await page.textContent('.headline'), /No claim was tried/);
    assert.match(await page.textContent('#advice'), /Cannot be said/);
    assert.equal(await page.locator('figure.plot').count(), 0);
    await atEnd(page);
  }
});

test('of recorded data no choice is offered', async () => {
  const experiments = [{ ...rich.experiments[0], name: 'recorded' }],
    page = await open(pageOf({ experiments }, 'recorded'));
  assert.equal(await page.locator('#advice').count(), 0);
  assert.ok(!(await page.textContent('body')).includes('Which one'));
  await atEnd(page);
});

const seriesOf = (m) => ({ scheme: m.scheme, quantity: m.quantity, observable: m.observable, over: m.over });
const described = (id, kind, rows, more = {}) => ({
  id,
  experiment: rows[0].experiment,
  kind,
  title: id,
  lines: [...new Set(rows.map((m) => JSON.stringify(seriesOf(m))))].map((s) => ({ series: JSON.parse(s) })),
  ...more,
});
const overDt = (dt) => ({ at: [{ name: 'dt', value: dt, unit: 'time' }], over: 'dt' });

test('what nobody has heard of is drawn, too', async () => {
  const row = {
    experiment: 'new <b>one</b>',
    quantity: 'mood',
    observable: 'x',
    at: [],
    over: '',
    low: null,
    high: null,
    unit: 'sighs',
    method: 'asked',
    status: 'ok',
    used: false,
  };
  const moods = ['a', 'b'].flatMap((scheme) =>
    [1, 2, 4].map((dt) => ({ ...row, ...overDt(dt), scheme, value: dt ** 2 })),
  );
  const size = { ...row, scheme: 'a', value: 3, quantity: 'size' },
    weight = { ...row, scheme: '', value: 7, quantity: 'weight', observable: '' };
  const plots = [
    described('mood', 'curve', moods, { x: 'dt' }),
    described('size', 'comparison', [size]),
    described('facts', 'facts', [weight]),
    described('dream', 'hologram', [size]),
  ];
  const measurements = [...moods, size, weight];
  const page = await open(
    pageOf({ ...rich, measurements, plots, fits: [], densities: [], verdicts: [], skipped: [] }, 'unknown'),
  );
  assert.equal(await page.locator('figure.curve[data-points="6"]').count(), 1);
  assert.equal(await page.locator('figure.plot').count(), 2);
  assert.match(await page.locator('section.experiment').last().textContent(), /weight.*7/s);
  await atEnd(page);
});

/** The results with a text wherever somebody may have written one: names, units, sources, reasons. */
function told(text) {
  const all = (rows, ...keys) => rows.map((row) => ({ ...row, ...Object.fromEntries(keys.map((key) => [key, text])) }));
  return {
    ...rich,
    scene: { ...rich.scene, name: text },
    provenance: { ...rich.provenance, cpu: text, flags: text, compiler: text },
    schemes: all(rich.schemes, 'title', 'source'),
    experiments: rich.experiments.map((e) => ({ ...e, question: text, notes: [text] })),
    measurements: all(rich.measurements, 'unit', 'method'),
    fits: all(rich.fits, 'rule'),
    verdicts: all(rich.verdicts, 'claim', 'reason'),
    skipped: all(rich.skipped, 'reason'),
  };
}

test('a name is text, whatever it is made of', async () => {
  const elements = async (text, label) => {
    const page = await open(pageOf(told(text), label));
    await page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
    await page.locator('.verdict-row').first().waitFor();
    assert.equal(await page.textContent('h1'), text);
    assert.equal(await page.locator('img, iframe, main script, [onload], [onerror], [onmouseover]').count(), 0);
    const found = await page.evaluate(() =>
      // Figures are drawn when they come near the screen.
      [...document.querySelectorAll('*')].filter((e) => !e.closest('figure')).map((e) => e.tagName),
    );
    await atEnd(page); // no dialog, no request, no complaint
    return found.length;
  };
  const plain = await elements('a name', 'name');
  for (const [i, text] of [
    "\"><svg onload=alert(1)>' onmouseover='alert(1)",
    '<a href="javascript:alert(1)">here</a><!--<script>alert(1)//',
    '</title></script></style><style>*{display:none}</style><script>alert(1)</script>',
    '&lt;img src=x onerror=alert(1)&gt;&#60; ${alert(1)} \\u003cscript> ../../x 🌀 \u2028\u202e',
  ].entries())
    assert.equal(await elements(text, `name${i}`), plain, text);
});

test('a hundred thousand measurements stay usable', async () => {
  const row = {
    experiment: 'strong',
    quantity: 'error',
    low: null,
    high: null,
    unit: '1',
    method: 'sampled',
    status: 'ok',
    used: false,
  };
  const measurements = Array.from({ length: 100_000 }, (_, i) => ({
    ...row,
    scheme: i % 2 ? 'heun' : 'magnus',
    observable: i < 99_000 ? 'state' : `o ${i}`,
    ...overDt(0.001 + i * 1e-6),
    value: 1e-3 * (1 + (i % 97)),
  }));
  const plots = [measurements.slice(0, 99_000), ...measurements.slice(99_000).map((m) => [m])].map((rows, i) =>
    described(`strong.${i}`, 'curve', rows, { x: 'dt' }),
  );
  const start = Date.now(),
    page = await open(pageOf({ ...rich, measurements, plots, fits: [], densities: [] }, 'many'));
  assert.ok(Date.now() - start < 20_000);
  const figure = page.locator('figure[data-points="99000"]');
  await figure.evaluate((f) => f.scrollIntoView());
  await until(() => figure.evaluate((f) => f.figure.chart !== null));
  await figure.locator('.behind summary').click();
  await figure.locator('.behind tbody tr').first().waitFor();
  assert.match(await figure.textContent(), /The first 500 of 99000/);
  const csv = (
    await downloaded(page, () => figure.getByRole('button', { name: 'CSV', exact: true }).click())
  ).toString();
  assert.equal(csv.split('\r\n').length, 99_002);
  assert.match(await page.textContent('[id="experiment.strong"]'), /more plots are left out/);
  await atEnd(page);
});
