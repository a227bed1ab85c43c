// SPDX-License-Identifier: Apache-2.0
// What one report looks like: the globe, turned; on paper; dark and light, wide and narrow; without WebGL.
//
//   node looks_test.mjs POLHODE [FOLDER]
//
// Screenshots go to FOLDER (pictures). POLHODE_RESULTS names a results.json to look at instead of a short run of the scene `paper`.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { pageOf } from './pages.mjs';
import { until } from './plots.mjs';
import { richResults } from './rich.mjs';
import { atEnd, downloaded, open } from './visit.mjs';

const [polhode, pictures = 'pictures'] = process.argv.slice(2);
mkdirSync(pictures, { recursive: true });
const rich = richResults(polhode);

describe('one report', () => {
  let page;
  before(async () => {
    page = await open(pageOf(rich, 'rich'));
  });
  after(() => atEnd(page));

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
