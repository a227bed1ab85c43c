// The report as a person meets it: opened from the file system in Chromium, looked at, clicked, hovered, saved, printed.
//
//   node report_test.mjs SAMPLE_PROGRAM POLHODE [FOLDER]
//
// SAMPLE_PROGRAM writes the golden sample's reports, POLHODE those of the built-in scenes; screenshots go to FOLDER.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { browser, densities, pageOf, scratch } from './pages.mjs';
import { drawn, groupsIn, key, tooltipAt, until } from './plots.mjs';

const [sampleProgram, polhode, pictures = join(scratch, 'pictures')] = process.argv.slice(2);
const hostile = '</script><img src=x onerror=alert(1)>';
mkdirSync(pictures, { recursive: true });

let chromium;
const faults = [];

/** A page that remembers what it complained of and what it asked for. */
async function open(url, options = {}) {
  const { prepare, ...more } = options;
  const context = await chromium.newContext({ viewport: { width: 1440, height: 900 }, acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.on('console', (m) => ['error', 'warning'].includes(m.type()) && faults.push(`${url}: ${m.text()}`));
  page.on('pageerror', (e) => faults.push(`${url}: ${e.message}`));
  page.on('request', (r) => {
    const asked = r.url();
    if (asked.split('#')[0] !== url.split('#')[0] && !/^(data|blob):/.test(asked)) faults.push(`${url} asks for ${asked}`);
  });
  page.on('dialog', (d) => {
    faults.push(`${url}: dialog ${d.message()}`);
    void d.dismiss();
  });
  if (prepare) await page.addInitScript(prepare);
  await page.goto(url);
  await page.waitForSelector('main');
  return page;
}

/** Brings every figure near the screen once, so that all are drawn. */
async function drawAll(page) {
  for (const figure of await page.$$('figure.plot')) {
    await figure.scrollIntoViewIfNeeded();
    await until(() => figure.evaluate((f) => f.figure.chart !== null || f.classList.contains('globe')));
  }
}

async function downloaded(page, click) {
  const [download] = await Promise.all([page.waitForEvent('download'), click()]);
  return readFileSync(await download.path());
}

async function atEnd(page) {
  await page.context().close();
  assert.deepEqual(faults.splice(0), []);
}

const reports = {};
let rich;  // results of a scene with every kind of plot that the quick run gives, and densities

before(async () => {
  execFileSync(sampleProgram, [join(scratch, 'sample')]);
  const names = JSON.parse(execFileSync(polhode, ['list', 'scenes', '--format', 'json'])).map((s) => s.name);
  execFileSync(polhode, ['verify', ...names, '--effort', 'quick', '--experiments', 'strong,energy,lyapunov', '--schemes', 'heun,magnus', '--no-cache', '--quiet',
    '--out', join(scratch, 'scenes')]);
  for (const name of names) reports[name] = join(scratch, 'scenes', name);
  rich = JSON.parse(readFileSync(process.env.POLHODE_RESULTS ?? join(reports.paper, 'results.json'), 'utf8'));
  rich.densities = densities();
  chromium = await browser();
});

after(() => chromium?.close());

test('every built-in scene opens: no complaint, no request, under 4 MB', async () => {
  for (const folder of Object.values(reports)) {
    const file = join(folder, 'report.html');
    assert.ok(statSync(file).size < 4_000_000);
    const page = await open(pathToFileURL(file).href), results = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));
    assert.equal(await page.textContent('h1'), results.scene.name);
    assert.equal(await page.locator('section.experiment').count(), new Set(results.experiments.map((e) => e.name)).size);
    await drawAll(page);
    await holdsEveryNumber(page, results);
    await atEnd(page);
  }
});

/** Each number of the data is drawn once where it has an abscissa, and stands in the page in any case. */
async function holdsEveryNumber(page, results) {
  const items = await drawn(page), groups = groupsIn(results);
  const seen = new Map();
  for (const { row } of items) seen.set(key(row), (seen.get(key(row)) ?? 0) + 1);
  for (const [name, rows] of groups)
    for (const row of rows) assert.ok(seen.has(key(row)), `${name}: ${JSON.stringify(row)} is in no plot`);
  for (const [name, rows] of groups) {
    const plots = new Map();
    for (const { row, figure } of items) if (rows.some((r) => key(r) === key(row))) plots.set(figure, (plots.get(figure) ?? 0) + 1);
    assert.ok([...plots.values()].includes(rows.length), `${name}: ${rows.length} points, drawn ${JSON.stringify([...plots])}`);
  }
}

test('the sample: hostile names stay text, everything is in the page', async () => {
  const folder = join(scratch, 'sample', 'plain'), results = JSON.parse(readFileSync(join(folder, 'results.json'), 'utf8'));
  for (const file of ['script_img_src=x_onerror=alert_1-02e60bcd', 'plain'].map((f) => join(scratch, 'sample', f, 'report.html'))) {
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
    for (const kind of ['holds', 'refuted', 'inconclusive', 'skipped'])
      assert.equal(await count(`.verdict-row[data-verdict=${kind}]`), results.verdicts.filter((v) => v.verdict === kind).length);
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

describe('one report', () => {
  let page;
  before(async () => {
    page = await open(pageOf(rich, 'rich'));
  });
  after(() => atEnd(page));

  test('hover shows the number of results.json, in every plot', async () => {
    for (const figure of await page.$$('figure.plot:not(.globe)')) {
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
    const opacities = () => page.$$eval('figure.curve', (figures) => figures.flatMap((f) => f.figure.chart.getOption().series
      .filter((s) => s.data.some((d) => d.item) && s.name !== 'no scheme').map((s) => [s.name, s.itemStyle.opacity])));
    const isolated = await opacities();
    assert.ok(isolated.length > 4);
    for (const [name, opacity] of isolated) assert.ok(name === 'magnus' ? opacity === 1 : opacity < 0.2, `${name}: ${opacity}`);
    assert.equal(await page.locator('.bar select.chosen').inputValue(), 'magnus');
    const again = await open(page.url());
    assert.equal(await again.locator('.bar select.chosen').inputValue(), 'magnus');
    await atEnd(again);
    await entry.click();
    await drawAll(page);
    for (const [name, opacity] of await opacities()) assert.equal(opacity, 1, name);
  });

  test('a permalink goes to its plot', async () => {
    const figure = page.locator('figure.plot').last(), id = await figure.getAttribute('id');
    await figure.locator('.permalink').click();
    assert.ok(decodeURIComponent(page.url()).includes(`#${id}`));
    const again = await open(page.url());
    await again.waitForTimeout(300);
    const box = await again.locator(`[id="${id}"]`).boundingBox();
    assert.ok(box.y >= 0 && box.y < 900, `${id} at ${box.y}`);
    await atEnd(again);
  });

  test('logarithmic and linear', async () => {
    const figure = page.locator('figure.curve').first(), button = figure.getByRole('button', { name: 'log y' });
    await figure.scrollIntoViewIfNeeded();
    const least = () => figure.evaluate((f) => f.figure.chart.getOption().yAxis[0].min);
    const before = await least();
    await button.click();
    assert.equal(await button.getAttribute('aria-pressed'), 'false');
    assert.notEqual(await least(), before);
    await button.click();
    assert.equal(await least(), before);
  });

  test('SVG, PNG and CSV are saved', async () => {
    const figure = page.locator('figure.curve').first(), tool = (name) => () => figure.getByRole('button', { name, exact: true }).click();
    const svg = (await downloaded(page, tool('SVG'))).toString(), title = (await figure.locator('figcaption').textContent()).replace('#', '');
    const problem = await page.evaluate((text) => new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror')?.textContent ?? '', svg);
    assert.equal(problem, '');
    assert.ok(svg.includes(title.replace(/[<>&]/g, '')) && svg.startsWith('<svg'));
    const png = await downloaded(page, tool('PNG'));
    assert.deepEqual([...png.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.ok(png.readUInt32BE(16) >= 1600, 'sharp enough for a screen of double density');
    const csv = (await downloaded(page, tool('CSV'))).toString().trim().split('\r\n');
    const rows = await figure.evaluate((f) => f.figure.plot.rows);
    assert.equal(csv.length, rows.length + 1);
    rows.forEach((row, i) => assert.equal(csv[i + 1].split(',')[6], row.value === null ? '' : String(row.value)));
  });

  test('the table behind a plot holds its numbers', async () => {
    const figure = page.locator('figure.curve').first();
    await figure.locator('.behind summary').click();
    const rows = await figure.evaluate((f) => f.figure.plot.rows);
    await figure.locator('.behind tbody tr').first().waitFor();
    assert.equal(await figure.locator('.behind tbody tr').count(), Math.min(500, rows.length));
    assert.equal(Number(await figure.locator('.behind tbody tr').first().locator('td').nth(3).textContent()), rows[0].value);
  });

  test('a cell of the board opens its claims with their reasons', async () => {
    const cell = page.locator('.board .cell').first();
    await cell.focus();
    await page.keyboard.press('Enter');
    const text = await page.locator('dialog').textContent(), scheme = rich.verdicts[0].scheme, experiment = rich.verdicts[0].experiment;
    for (const v of rich.verdicts.filter((one) => one.scheme === scheme && one.experiment === experiment)) assert.ok(text.includes(v.reason), v.reason);
    await page.keyboard.press('Escape');
    await page.waitForSelector('dialog', { state: 'detached' });
  });

  test('the globe is drawn, and turns by keys and by hand', async () => {
    const globe = page.locator('figure.globe');
    await globe.scrollIntoViewIfNeeded();
    await globe.getByRole('button', { name: 't = 12.5' }).click();
    const picture = () => globe.locator('canvas.round').evaluate((canvas) => {
      const gl = canvas.getContext('webgl2'), pixels = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return { sum: pixels.reduce((a, b, i) => (a * 31 + b * (i % 251)) % 1e9, 7), colours: new Set(new Uint32Array(pixels.buffer)).size };
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
    const csv = (await downloaded(page, () => globe.getByRole('button', { name: 'CSV' }).click())).toString().trim().split('\r\n');
    assert.equal(csv.length, 1 + rich.densities.reduce((n, d) => n + d.values.length, 0));
    await globe.screenshot({ path: join(pictures, 'globe.png') });
  });

  test('on paper every plot is there, light', async () => {
    const figures = await page.locator('figure.plot').count();
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    await until(() => page.evaluate((n) => document.querySelectorAll('figure.plot > .printed > *').length >= n, figures));
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
      const first = await background(), [red] = first.match(/\d+/g).map(Number);
      assert.ok(colorScheme === 'dark' ? red < 60 : red > 200, first);
      await page.screenshot({ path: join(pictures, `first-${width}-${colorScheme}.png`) });
      await page.locator('button.theme').click();
      assert.notEqual(await background(), first);
      await atEnd(page);
    }
});

test('without WebGL the sphere is a flat map', async () => {
  const page = await open(pageOf(rich, 'flat'), { prepare: () => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
      return kind === 'webgl2' ? null : get.call(this, kind, ...more);
    };
  } });
  const globe = page.locator('figure.globe');
  await globe.scrollIntoViewIfNeeded();
  assert.match(await globe.textContent(), /No WebGL here/);
  const colours = await globe.locator('canvas.flat').evaluate((canvas) =>
    new Set(new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size);
  assert.ok(colours >= 2);
  await atEnd(page);
});

test('what cannot be read is said in one line', async () => {
  for (const [label, text] of [['truncated', JSON.stringify(rich).slice(0, 5000)], ['empty', ''], ['array', '[1,2]'], ['word', 'results']]) {
    const page = await open(pageOf(text, label));
    const said = await page.textContent('main');
    assert.match(said, /^These results cannot be read/);
    assert.ok(!said.includes('\n') && said.length < 300);
    await atEnd(page);
  }
});

test('an older schema is shown with what it has', async () => {
  const old = structuredClone(rich);
  old.schema.version = 0;
  for (const name of ['fits', 'savings', 'reused', 'counters', 'densities', 'experiments']) delete old[name];
  for (const m of old.measurements) {
    delete m.fitted;
    delete m.status;
  }
  const page = await open(pageOf(old, 'old')), note = await page.textContent('.lacking');
  for (const part of ['schema version 0', 'fits', 'experiments', 'fitted', 'status']) assert.ok(note.includes(part), part);
  assert.ok(await page.locator('figure.plot').count() > 3);
  await atEnd(page);
});

test('nothing measured, nothing at all', async () => {
  for (const [label, results] of [['none', { ...rich, measurements: [], fits: [], verdicts: [], skipped: [], densities: [] }], ['bare', {}]]) {
    const page = await open(pageOf(results, label));
    assert.match(await page.textContent('.headline'), /No claim was tried/);
    assert.match(await page.textContent('#advice'), /Cannot be said/);
    assert.equal(await page.locator('figure.plot').count(), 0);
    await atEnd(page);
  }
});

test('what nobody has heard of is drawn, too', async () => {
  const row = { experiment: 'new <b>one</b>', quantity: 'mood', observable: 'x', steps: null, low: null, high: null, unit: 'sighs', method: 'asked', status: 'ok', fitted: false };
  const measurements = ['a', 'b'].flatMap((scheme) => [1, 2, 4].map((dt) => ({ ...row, scheme, dt, value: dt ** 2 })));
  measurements.push({ ...row, scheme: 'a', dt: null, value: 3, quantity: 'size' }, { ...row, scheme: '', dt: null, value: 7, quantity: 'weight', observable: '' });
  const page = await open(pageOf({ ...rich, measurements, fits: [], densities: [], verdicts: [], skipped: [] }, 'unknown'));
  assert.equal(await page.locator('figure.curve[data-points="6"]').count(), 1);
  assert.match(await page.locator('section.experiment').last().textContent(), /weight.*7/s);
  await atEnd(page);
});

test('a hundred thousand measurements stay usable', async () => {
  const row = { experiment: 'strong', quantity: 'error', steps: null, low: null, high: null, unit: '1', method: 'sampled', status: 'ok', fitted: false };
  const measurements = Array.from({ length: 100_000 }, (_, i) => ({ ...row, scheme: i % 2 ? 'heun' : 'magnus', observable: i < 99_000 ? 'state' : `o ${i}`,
    dt: 0.001 + i * 1e-6, value: 1e-3 * (1 + (i % 97)) }));
  const start = Date.now(), page = await open(pageOf({ ...rich, measurements, fits: [], densities: [] }, 'many'));
  assert.ok(Date.now() - start < 20_000);
  const figure = page.locator('figure[data-points="99000"]');
  await figure.scrollIntoViewIfNeeded();
  await until(() => figure.evaluate((f) => f.figure.chart !== null));
  await figure.locator('.behind summary').click();
  await figure.locator('.behind tbody tr').first().waitFor();
  assert.match(await figure.textContent(), /The first 500 of 99000/);
  const csv = (await downloaded(page, () => figure.getByRole('button', { name: 'CSV', exact: true }).click())).toString();
  assert.equal(csv.split('\r\n').length, 99_002);
  assert.match(await page.textContent('[id="experiment.strong"]'), /more plots are left out/);
  await atEnd(page);
});
