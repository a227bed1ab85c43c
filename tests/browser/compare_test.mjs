// SPDX-License-Identifier: Apache-2.0
// A report with an earlier one beside it: a planted regression is said first, and the earlier points are drawn behind.
//
//   node compare_test.mjs POLHODE [FOLDER]
//
// Screenshots go to FOLDER (pictures). POLHODE_BEFORE and POLHODE_AFTER name two results.json to look at instead.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { scratch } from './pages.mjs';
import { key, numbersIn, until } from './plots.mjs';
import { atEnd, downloaded, drawAll, open } from './visit.mjs';

const [polhode, pictures = 'pictures'] = process.argv.slice(2);
const hostile = '</script><img src=x onerror=alert(1)>';
let old;

before(() => {
  mkdirSync(pictures, { recursive: true });
  const options = ['--effort', 'quick', '--experiments', 'strong,energy,casimir', '--schemes', 'heun,magnus'];
  const run = ['verify', 'paper', ...options, '--no-cache', '--format', 'json', '--out', join(scratch, 'paper')];
  const output = { maxBuffer: 1e9, stdio: ['ignore', 'pipe', 'ignore'] };
  old = JSON.parse(readFileSync(process.env.POLHODE_BEFORE ?? '/dev/null') + '' || execFileSync(polhode, run, output));
  old.scene.name = hostile;
});

const isError = (r, m) =>
  m.value !== null &&
  r.fits.some((f) => ['experiment', 'scheme', 'quantity', 'observable', 'over'].every((k) => f[k] === m[k]));

/** Errors of magnus thrice as large, one claim refuted, one open, and another processor. */
function worsened() {
  const r = structuredClone(old);
  r.provenance.cpu = `another ${hostile}`;
  for (const m of r.measurements.filter((one) => one.scheme === 'magnus' && isError(r, one)))
    for (const part of ['value', 'low', 'high']) if (m[part] !== null) m[part] *= 3;
  const held = r.verdicts.filter((v) => v.verdict === 'holds');
  held[0].verdict = 'refuted';
  held[1].verdict = 'inconclusive';
  return r;
}

/** As a user makes it; the comparison is what goes to standard output. */
function compared(after, label) {
  const files = ['before', 'after'].map((name) => join(scratch, `${label}-${name}.json`)),
    page = join(scratch, `${label}.html`);
  writeFileSync(files[0], JSON.stringify(old));
  writeFileSync(files[1], JSON.stringify(after));
  const run = spawnSync(polhode, ['compare', ...files, '--html', page, '--format', 'json'], { maxBuffer: 1e9 });
  assert.equal(String(run.stderr), '');
  return { url: pathToFileURL(page).href, comparison: JSON.parse(run.stdout), code: run.status };
}

test('a regression stands before the board, with its numbers', async () => {
  const { url, comparison, code } = compared(worsened(), 'worse');
  assert.equal(code, 1);
  const page = await open(url);
  assert.equal(await page.textContent('h1'), hostile);
  assert.equal(await page.locator('img, iframe, main script').count(), 0);
  const order = await page.$$eval('main > *', (all) => all.map((one) => one.id || one.tagName));
  assert.ok(order.indexOf('changes') > 0 && order.indexOf('changes') < order.indexOf('board'), order.join());
  const text = await page.textContent('#changes');
  assert.ok(text.includes(`another ${hostile}`));
  assert.match(text, /Timings are not compared: processor/);
  assert.ok(text.indexOf('The runs themselves differ') < text.indexOf('Worse:'));
  const of = (kind) => comparison.changes.filter((c) => c.kind === kind);
  assert.ok(of('worse').length > 4 && of('no longer shown to hold').length === 1);
  for (const kind of ['worse', 'no longer shown to hold', 'better', 'different']) {
    const rows = page.locator(`.change[data-kind="${kind}"]`);
    assert.equal(await rows.count(), Math.min(50, of(kind).length), kind);
    if (of(kind).length > 0) assert.ok(text.toLowerCase().includes(`${kind}: ${of(kind).length}`), kind);
  }
  assert.match(text, new RegExp(`${of('worse').length} are worse, 1 is no longer shown to hold`));
  assert.ok(await page.locator('.change', { hasText: '× 3' }).first().isVisible());
  const csv = await downloaded(page, () => page.locator('#changes .tools button').click());
  assert.equal(csv.toString().trim().split('\r\n').length, 1 + comparison.changes.length);
  await atEnd(page);
});

const curvesOf = (r) => {
  const known = new Set(r.schemes.map((s) => s.name).concat(''));
  return r.measurements.filter((m) => m.value !== null && m.method !== 'timed' && m.over !== '' && known.has(m.scheme));
};

const itemsIn = (page) =>
  page.$$eval('figure.plot:not(.globe)', (figures) =>
    figures.flatMap((f) =>
      f.figure.chart.getOption().series.flatMap((s) =>
        (s.data ?? [])
          .filter((d) => d?.item?.run)
          .map((d) => ({
            run: d.item.run,
            row: d.item.rows[0],
            opacity: s.itemStyle.opacity,
            colour: s.itemStyle.color,
          })),
      ),
    ),
  );

test('the earlier points are drawn behind, faint, in the colour of their scheme', async () => {
  const after = worsened(),
    page = await open(compared(after, 'behind').url);
  await drawAll(page);
  const items = await itemsIn(page),
    earlier = items.filter((i) => i.run === 'earlier run'),
    seen = new Set(earlier.map((i) => key(i.row)));
  assert.ok(curvesOf(old).length > 0);
  for (const m of curvesOf(old)) assert.ok(seen.has(key(m)), JSON.stringify(m));
  assert.equal(earlier.length, items.length - earlier.length);
  for (const { row, opacity, colour } of earlier) {
    const same = items.find((i) => i.run === 'this run' && i.row.scheme === row.scheme && i.colour === colour);
    assert.ok(same && opacity < 0.5 && same.opacity === 1);
  }
  await page.screenshot({ path: join(pictures, 'compare-page.png'), fullPage: true });
  await atEnd(page);
});

test('a plot tells which run, leaves the earlier one out, and its table and CSV name both', async () => {
  const page = await open(compared(worsened(), 'plot').url),
    figure = page.locator('figure.curve[id^="strong"]').first();
  await figure.scrollIntoViewIfNeeded();
  await until(() => figure.evaluate((f) => f.figure.chart !== null));
  const at = await figure.evaluate((f) => {
    const { chart } = f.figure,
      series = chart.getOption().series,
      index = series.findIndex((s) => s.name === 'magnus, earlier run');
    const point = series[index].data[0],
      [x, y] = chart.convertToPixel({ seriesIndex: index }, point.value),
      box = f.querySelector('.chart').getBoundingClientRect();
    return { x: box.left + x, y: box.top + y, value: point.item.rows[0].value };
  });
  await page.mouse.move(at.x - 2, at.y - 2);
  await page.mouse.move(at.x, at.y);
  const tip = await (await figure.elementHandle()).waitForSelector('.tip', { state: 'visible' }),
    said = await tip.innerText();
  assert.match(said, /earlier run/);
  assert.ok(numbersIn(said).has(at.value), said);
  await figure.screenshot({ path: join(pictures, 'compare-plot.png') });
  const rows = await figure.evaluate((f) => [f.figure.plot.rows.length, f.figure.plot.earlier.rows.length]);
  await figure.locator('.behind summary').click();
  await figure.locator('.behind tbody tr').first().waitFor();
  const runs = await figure.locator('.behind tbody td:last-child').allTextContents();
  assert.deepEqual([runs.filter((r) => r === 'this').length, runs.filter((r) => r === 'earlier').length], rows);
  const csv = await downloaded(page, () => figure.getByRole('button', { name: 'CSV', exact: true }).click());
  assert.equal(
    csv
      .toString()
      .split('\r\n')
      .filter((line) => line.endsWith(',earlier')).length,
    rows[1],
  );
  const behind = () =>
    figure.evaluate((f) => f.figure.chart.getOption().series.filter((s) => /earlier run$/.test(s.name)).length);
  const button = figure.getByRole('button', { name: 'earlier run' });
  assert.equal(await button.getAttribute('aria-pressed'), 'true');
  assert.equal(await behind(), 2);
  assert.match(await figure.evaluate((f) => f.figure.toSvg()), /the earlier run/);
  await button.click();
  assert.equal(await behind(), 0);
  await atEnd(page);
});

test('nothing has changed, and it says so', async () => {
  const { url, code } = compared(old, 'same');
  assert.equal(code, 0);
  const page = await open(url);
  assert.match(await page.textContent('#changes'), /Nothing has changed beyond noise\..*settings are the same/s);
  assert.equal(await page.locator('.change').count(), 0);
  await atEnd(page);
});

test('wide and narrow, light and dark', async () => {
  const given = process.env.POLHODE_AFTER,
    { url } = compared(given ? { ...JSON.parse(readFileSync(given)), scene: old.scene } : worsened(), 'looks');
  for (const [width, colorScheme] of [
    [1440, 'light'],
    [390, 'light'],
    [1440, 'dark'],
  ]) {
    const page = await open(url, { colorScheme, viewport: { width, height: 900 } });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, 'nothing sticks out');
    await page.screenshot({ path: join(pictures, `compare-${width}-${colorScheme}.png`) });
    if (width === 390) {
      await page.evaluate(() => document.querySelector('.changed').scrollIntoView());
      await page.screenshot({ path: join(pictures, 'compare-390-tables.png') });
    }
    await atEnd(page);
  }
});
