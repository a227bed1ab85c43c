// SPDX-License-Identifier: Apache-2.0
// One browser, and pages in it that remember what they complained of and what they asked for.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before } from 'node:test';
import { viewer } from './pages.mjs';
import { until } from './plots.mjs';

const { chromium } = createRequire(viewer)('playwright-core');
const faults = [];
let browser;

before(async () => {
  browser = await chromium.launch({
    executablePath: process.env.POLHODE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
});
after(() => browser?.close());

/** A page that remembers what it complained of and what it asked for. */
export async function open(url, options = {}) {
  const { prepare, ...more } = options;
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.on('console', (m) => ['error', 'warning'].includes(m.type()) && faults.push(`${url}: ${m.text()}`));
  page.on('pageerror', (e) => faults.push(`${url}: ${e.message}`));
  page.on('request', (r) => {
    const asked = r.url();
    if (asked.split('#')[0] !== url.split('#')[0] && !/^(data|blob):/.test(asked))
      faults.push(`${url} asks for ${asked}`);
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
export async function drawAll(page) {
  for (const figure of await page.$$('figure.plot')) {
    await figure.scrollIntoViewIfNeeded();
    await until(() => figure.evaluate((f) => f.figure.chart !== null || f.classList.contains('globe')));
  }
}

export async function downloaded(page, click) {
  const [download] = await Promise.all([page.waitForEvent('download'), click()]);
  return readFileSync(await download.path());
}

export async function atEnd(page) {
  await page.context().close();
  assert.deepEqual(faults.splice(0), []);
}
