// SPDX-License-Identifier: Apache-2.0
// The table of the catalogue of schemes: sorted both ways by a click, filtered by words and by columns, usable on a phone.
//
//   node catalogue_test.mjs POLHODE
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { atEnd, open } from './visit.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'catalogue-'));
after(() => rmSync(folder, { recursive: true }));
const catalogue = join(root, 'docs/site/catalogue.py');
execFileSync('python3', [catalogue, process.argv[2], join(root, 'reports/baseline'), join(folder, 'pages')]);

const index = readFileSync(join(folder, 'pages/index.md'), 'utf8');
const table = index.match(/```\{raw\} html\n([\s\S]*?)\n```/)[1];
const file = join(folder, 'index.html');
const address = pathToFileURL(file).href;
const site = join(root, 'docs/site/static');
writeFileSync(
  file,
  `<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width">
  <style>${readFileSync(join(site, 'site.css'), 'utf8')}</style><script>${readFileSync(join(site, 'catalogue.js'), 'utf8')}</script>
  <main>${table}</main>`,
);

const column = (page, head) =>
  page.evaluate((text) => {
    const shown = document.querySelector('table.catalogue');
    const at = [...shown.tHead.rows[0].cells].findIndex((cell) => cell.textContent === text);
    return [...shown.tBodies[0].rows].filter((row) => !row.hidden).map((row) => row.cells[at].dataset.value);
  }, head);

test('a click on a head sorts, a second one the other way', async () => {
  const page = await open(address);
  for (const head of ['ns a step', 'largest stable dt']) {
    await page.getByRole('button', { name: head }).click();
    const up = (await column(page, head)).map(Number);
    assert.ok(up.length > 10);
    assert.deepEqual(
      up,
      [...up].sort((a, b) => a - b),
    );
    await page.getByRole('button', { name: head }).click();
    assert.deepEqual(
      (await column(page, head)).map(Number),
      [...up].sort((a, b) => b - a),
    );
  }
  await page.getByRole('button', { name: 'scheme' }).click();
  const names = await column(page, 'scheme');
  assert.deepEqual(
    names,
    [...names].sort((a, b) => a.localeCompare(b)),
  );
  await atEnd(page);
});

test('the field filters by words, and by a column', async () => {
  const page = await open(address);
  const field = page.getByRole('searchbox');
  await field.fill('implicit=yes');
  const implicit = await column(page, 'implicit');
  assert.ok(implicit.length > 0 && implicit.every((value) => value === 'yes'));
  await field.fill('strang keepscasimirs=yes');
  const names = await column(page, 'scheme');
  assert.ok(names.length >= 2 && names.every((name) => name.includes('strang')));
  await field.fill('no such scheme');
  assert.deepEqual(await column(page, 'scheme'), []);
  await field.fill('');
  assert.ok((await column(page, 'scheme')).length > 10);
  await atEnd(page);
});

test('on a phone the table scrolls and the page does not', async () => {
  const page = await open(address);
  await page.setViewportSize({ width: 390, height: 800 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= 390, `${wide}`);
  await atEnd(page);
});
