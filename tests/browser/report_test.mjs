// One report as a person meets it: hovered, clicked, isolated, saved, turned, printed; dark and light, wide and narrow.
//
//   node report_test.mjs POLHODE [FOLDER]
//
// Screenshots go to FOLDER. POLHODE_RESULTS names a results.json to look at instead of a short run of the scene `paper`.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { densities, pageOf, scratch } from './pages.mjs';
import { tooltipAt, until } from './plots.mjs';
import { atEnd, downloaded, drawAll, open } from './visit.mjs';

const [polhode, pictures = join(scratch, 'pictures')] = process.argv.slice(2);
let rich; // plots of every kind, and densities

before(() => {
  mkdirSync(pictures, { recursive: true });
  const options = ['--effort', 'quick', '--experiments', 'casimir,strong,energy,stability,work_precision,lyapunov'];
  const run = ['verify', 'paper', ...options, '--schemes', 'heun,magnus', '--no-cache', '--format', 'json'];
  const given = process.env.POLHODE_RESULTS;
  const text = given
    ? readFileSync(given)
    : execFileSync(polhode, [...run, '--out', join(scratch, 'paper')], {
        maxBuffer: 1e9,
        stdio: ['ignore', 'pipe', 'ignore'],
      });
  rich = { ...JSON.parse(text), densities: densities() };
});

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

  test('the globe is drawn, and turns by keys and by hand', async () => {
    const globe = page.locator('figure.globe');
    await globe.scrollIntoViewIfNeeded();
    await globe.getByRole('button', { name: 't = 12.5' }).click();
    const picture = () =>
      globe.locator('canvas.round').evaluate((canvas) => {
        const gl = canvas.getContext('webgl2'),
          pixels = new Uint8Array(4 * canvas.width * canvas.height);
        gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return {
          sum: pixels.reduce((a, b, i) => (a * 31 + b * (i % 251)) % 1e9, 7),
          colours: new Set(new Uint32Array(pixels.buffer)).size,
        };
      });
    const first = await picture();
    assert.ok(first.colours > 100, `${first.colours} colours`);
    await globe.locator('.stage').focus();
    await page.keyboard.press('ArrowRight');
    const second = await picture();
    assert.notEqual(second.sum, first.sum);
    const box = await globe.locator('.stage').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 + 10, { steps: 4 });
    await page.mouse.up();
    assert.notEqual((await picture()).sum, second.sum);
    assert.match(await globe.locator('.readout').textContent(), /× uniform/);
    const csv = (await downloaded(page, () => globe.getByRole('button', { name: 'CSV' }).click()))
      .toString()
      .trim()
      .split('\r\n');
    assert.equal(csv.length, 1 + rich.densities.reduce((n, d) => n + d.values.length, 0));
    await globe.screenshot({ path: join(pictures, 'globe.png') });
  });

  test('on paper every plot is there, light', async () => {
    const figures = await page.locator('figure.plot').count();
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    await until(() =>
      page.evaluate((n) => document.querySelectorAll('figure.plot > .printed > *').length >= n, figures),
    );
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
    assert.equal(await page.locator('.chart:visible, .tools:visible, .bar:visible').count(), 0);
    await page.screenshot({ path: join(pictures, 'print.png'), fullPage: true });
    const pdf = await page.pdf({ format: 'A4', path: join(pictures, 'print.pdf') });
    assert.ok(pdf.length > 20_000 && pdf.subarray(0, 4).toString() === '%PDF');
    await page.emulateMedia({ media: 'screen', colorScheme: 'light' });
    assert.equal(await page.locator('.printed > *').count(), 0);
  });
});

test('dark and light, wide and narrow', async () => {
  for (const colorScheme of ['light', 'dark'])
    for (const width of [1440, 390]) {
      const page = await open(pageOf(rich, 'looks'), { colorScheme, viewport: { width, height: 900 } });
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, 'nothing sticks out');
      const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const first = await background(),
        [red] = first.match(/\d+/g).map(Number);
      assert.ok(colorScheme === 'dark' ? red < 60 : red > 200, first);
      await page.screenshot({ path: join(pictures, `first-${width}-${colorScheme}.png`) });
      await page.locator('button.theme').click();
      assert.notEqual(await background(), first);
      await atEnd(page);
    }
});

test('without WebGL the sphere is a flat map', async () => {
  const page = await open(pageOf(rich, 'flat'), {
    prepare: () => {
      const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind === 'webgl2' ? null : get.call(this, kind, ...more);
      };
    },
  });
  const globe = page.locator('figure.globe');
  await globe.scrollIntoViewIfNeeded();
  assert.match(await globe.textContent(), /No WebGL here/);
  const colours = await globe
    .locator('canvas.flat')
    .evaluate(
      (canvas) =>
        new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer))
          .size,
    );
  assert.ok(colours >= 2);
  await atEnd(page);
});
