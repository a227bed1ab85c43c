// SPDX-License-Identifier: Apache-2.0
// One report as a person uses it: hovered, clicked, isolated, linked to, saved.
//
//   node report_test.mjs POLHODE
//
// POLHODE_RESULTS names a results.json to look at instead of a short run of the scene `paper`.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { pageOf } from './pages.mjs';
import { tooltipAt, until } from './plots.mjs';
import { richResults } from './rich.mjs';
import { atEnd, downloaded, drawAll, open } from './visit.mjs';

const rich = richResults(process.argv[2]);

describe('one report', () => {
  let page;
  before(async () => {
    page = await open(pageOf(rich, 'rich'));
  });
  after(() => atEnd(page));

  test('hover shows the number of results.json, in every plot', async () => {
    const figures = await page.$$('figure.plot:not(.globe)');
    assert.ok(figures.length > 4, `${figures.length} plots`);
    for (const figure of figures) {
      await figure.scrollIntoViewIfNeeded();
      const { text, rows } = await tooltipAt(page, figure);
      assert.ok(rows.length > 0, `${await figure.getAttribute('id')}: no number of this plot in ${text}`);
    }
  });

  test('arrow keys go from point to point', async () => {
    const chart = page.locator('figure.curve .chart').first();
    await chart.focus();
    await page.keyboard.press('ArrowRight');
    const first = await page.locator('figure.curve .tip').first().textContent();
    await page.keyboard.press('ArrowRight');
    assert.notEqual(await page.locator('figure.curve .tip').first().textContent(), first);
  });

  test('a key entry isolates its scheme in all plots, and the address keeps it', async () => {
    const entry = page.locator('.key-entry', { hasText: 'magnus' }).first();
    await entry.scrollIntoViewIfNeeded();
    await entry.click();
    assert.match(page.url(), /scheme=magnus/);
    await drawAll(page);
    const opacities = () =>
      page.$$eval('figure.curve', (figures) =>
        figures.flatMap((f) =>
          f.figure.chart
            .getOption()
            .series.filter((s) => s.data.some((d) => d.item) && s.name !== 'no scheme')
            .map((s) => [s.name, s.itemStyle.opacity]),
        ),
      );
    const isolated = await opacities();
    assert.ok(isolated.length > 4);
    for (const [name, opacity] of isolated)
      assert.ok(name === 'magnus' ? opacity === 1 : opacity < 0.2, `${name}: ${opacity}`);
    assert.equal(await page.locator('.bar select.chosen').inputValue(), 'magnus');
    const again = await open(page.url());
    assert.equal(await again.locator('.bar select.chosen').inputValue(), 'magnus');
    await atEnd(again);
    await entry.click();
    await drawAll(page);
    for (const [name, opacity] of await opacities()) assert.equal(opacity, 1, name);
  });

  test('a permalink goes to its plot', async () => {
    const figure = page.locator('figure.plot').last(),
      id = await figure.getAttribute('id');
    await figure.locator('.permalink').click();
    assert.ok(decodeURIComponent(page.url()).includes(`#${id}`));
    const again = await open(page.url());
    await again.waitForTimeout(300);
    const box = await again.locator(`[id="${id}"]`).boundingBox();
    assert.ok(box.y >= 0 && box.y < 900, `${id} at ${box.y}`);
    await atEnd(again);
  });

  test('logarithmic and linear', async () => {
    const figure = page.locator('figure.curve').first(),
      button = figure.getByRole('button', { name: 'log y' });
    await figure.scrollIntoViewIfNeeded();
    const least = () => figure.evaluate((f) => f.figure.chart.getOption().yAxis[0].min);
    const before = await least();
    await button.click();
    assert.equal(await button.getAttribute('aria-pressed'), 'false');
    assert.notEqual(await least(), before);
    await button.click();
    assert.equal(await least(), before);
  });

  test('cost in what no machine changes', async () => {
    const figure = page.locator('[id="work-precision.cost.strong"]');
    await figure.scrollIntoViewIfNeeded();
    await until(() => figure.evaluate((f) => f.figure.chart !== null));
    await figure.getByRole('button', { name: 'steps' }).click();
    const drawn = await figure.evaluate((f) =>
      f.figure.chart
        .getOption()
        .series.flatMap((s) => s.data)
        .filter((d) => d?.item)
        .map((d) => [10 ** d.value[1], d.item.rows]),
    );
    assert.ok(drawn.length > 0);
    for (const [y, rows] of drawn) {
      const { value } = rows.find((m) => m.quantity === 'steps_per_time');
      assert.ok(Math.abs(y - value) < 1e-9 * value, `${y} is not ${value}`);
    }
    await figure.getByRole('button', { name: 'time' }).click();
  });

  test('SVG, PNG and CSV are saved', async () => {
    const figure = page.locator('figure.curve').first(),
      tool = (name) => () => figure.getByRole('button', { name, exact: true }).click();
    const svg = (await downloaded(page, tool('SVG'))).toString(),
      title = (await figure.locator('figcaption').textContent()).replace('#', '');
    const problem = await page.evaluate(
      (text) => new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror')?.textContent ?? '',
      svg,
    );
    assert.equal(problem, '');
    assert.ok(svg.includes(title.replace(/[<>&]/g, '')) && svg.startsWith('<svg'));
    const png = await downloaded(page, tool('PNG'));
    assert.deepEqual([...png.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.ok(png.readUInt32BE(16) >= 1600, 'sharp enough for a screen of double density');
    const csv = (await downloaded(page, tool('CSV'))).toString().trim().split('\r\n');
    const rows = await figure.evaluate((f) => f.figure.plot.rows);
    assert.equal(csv.length, rows.length + 1);
    rows.forEach((row, i) => assert.equal(csv[i + 1].split(',')[5], row.value === null ? '' : String(row.value)));
  });

  test('the table behind a plot holds its numbers', async () => {
    const figure = page.locator('figure.curve').first();
    await figure.locator('.behind summary').click();
    const rows = await figure.evaluate((f) => f.figure.plot.rows);
    await figure.locator('.behind tbody tr').first().waitFor();
    assert.equal(await figure.locator('.behind tbody tr').count(), Math.min(500, rows.length));
    assert.equal(
      Number(await figure.locator('.behind tbody tr').first().locator('td').nth(3).textContent()),
      rows[0].value,
    );
  });

  test('a cell of the board opens its claims with their reasons', async () => {
    const cell = page.locator('.board .cell').first();
    await cell.focus();
    await page.keyboard.press('Enter');
    const text = await page.locator('dialog').textContent(),
      scheme = rich.schemes[0].name,
      { experiment } = rich.verdicts.find((one) => one.scheme === scheme);
    for (const v of rich.verdicts.filter((one) => one.scheme === scheme && one.experiment === experiment))
      assert.ok(text.includes(v.reason), v.reason);
    await page.keyboard.press('Escape');
    await page.waitForSelector('dialog', { state: 'detached' });
  });
});
