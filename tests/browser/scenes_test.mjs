// SPDX-License-Identifier: Apache-2.0
// Reports as the program writes them: every built-in scene, and the golden sample with its hostile names.
//
//   node scenes_test.mjs SAMPLE_PROGRAM POLHODE
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { scratch } from './pages.mjs';
import { drawn, key, undescribed, valuesIn } from './plots.mjs';
import { atEnd, drawAll, open } from './visit.mjs';

const [sampleProgram, polhode] = process.argv.slice(2);
const hostile = '</script><img src=x onerror=alert(1)>';
const reports = {};

before(() => {
  execFileSync(sampleProgram, [join(scratch, 'sample')]);
  const names = JSON.parse(execFileSync(polhode, ['list', 'scenes', '--format', 'json'])).map((s) => s.name);
  const options = ['--effort', 'quick', '--experiments', 'strong,energy', '--schemes', 'heun,magnus'];
  const run = ['verify', ...names, ...options, '--no-cache', '--quiet', '--out', join(scratch, 'scenes')];
  assert.equal(spawnSync(polhode, run).status, 0);
  for (const name of names) reports[name] = join(scratch, 'scenes', name);
});

test('every built-in scene opens: no complaint, no request, under 2 MB', async () => {
  assert.ok(Object.keys(reports).includes('paper'));
  for (const folder of Object.values(reports)) {
    const file = join(folder, 'report.html');
    assert.ok(statSync(file).size < 2_000_000);
    const page = await open(pathToFileURL(file).href),
      results = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));
    assert.equal(await page.textContent('h1'), results.scene.name);
    assert.equal(
      await page.locator('section.experiment').count(),
      new Set(results.experiments.map((e) => e.name)).size,
    );
    await drawAll(page);
    await holdsEveryNumber(page, results);
    await atEnd(page);
  }
});

/** Each number that has an abscissa is in a plot, and each curve and map draws its own, once. */
async function holdsEveryNumber(page, results) {
  assert.deepEqual(undescribed(results), []);
  const items = await drawn(page);
  for (const [id, rows] of valuesIn(results)) {
    const own = items.filter((item) => item.figure === id).map((item) => key(item.row)),
      seen = new Set(own);
    for (const row of rows) assert.ok(seen.has(key(row)), `${id}: ${JSON.stringify(row)} is not drawn`);
    const wanted = new Set(rows.map(key));
    assert.equal(own.filter((one) => wanted.has(one)).length, rows.length, id);
  }
}

test('the sample: hostile names stay text, everything is in the page', async () => {
  const folder = join(scratch, 'sample', 'plain'),
    results = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));
  for (const file of ['script_img_src=x_onerror=alert_1-02e60bcd', 'plain'].map((f) =>
    join(scratch, 'sample', f, 'report.html'),
  )) {
    const page = await open(pathToFileURL(file).href);
    const text = await page.evaluate(() => {
      document.querySelectorAll('details').forEach((d) => (d.open = true));
      return new Promise((done) => setTimeout(() => done(document.body.textContent), 200));
    });
    if (!file.includes('plain')) {
      assert.equal(await page.textContent('h1'), hostile);
      assert.equal(await page.title(), `${hostile} · polhode`);
    }
    assert.ok(text.includes(hostile), 'the scheme of that name');
    assert.equal(await page.locator('img, iframe, main script').count(), 0);
    const count = (selector) => page.locator(selector).count();
    assert.equal(await count('.verdict-row'), results.verdicts.length);
    for (const kind of ['holds', 'refuted', 'inconclusive', 'not tried', 'skipped'])
      assert.equal(
        await count(`.verdict-row[data-verdict="${kind}"]`),
        results.verdicts.filter((v) => v.verdict === kind).length,
      );
    assert.equal(await count('tr.fit'), results.fits.length);
    assert.equal(await count('tr.scheme'), results.schemes.length);
    assert.equal(await count('tr.skip'), results.skipped.length);
    assert.equal(await count('tr.saving'), results.savings.length);
    assert.equal(await count('tr.reuse'), new Set(results.reused.map((r) => r.experiment + r.computed)).size);
    for (const v of results.verdicts) assert.ok(text.includes(v.reason), v.reason);
    assert.ok(text.includes('18446744073709551615'), 'a seed of 64 bits keeps its digits');
    await drawAll(page);
    for (const figure of await page.$$('figure.plot')) {
      const [svg, error] = await figure.evaluate((f) => {
        const text = f.figure.toSvg();
        return [text, new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror')?.textContent];
      });
      assert.equal(error, undefined);
      assert.ok(!svg.includes('<img'));
      assert.ok(!/NaN|Infinity/.test(svg), 'a coordinate that is no number');
    }
    await atEnd(page);
  }
});
