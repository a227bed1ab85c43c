// SPDX-License-Identifier: Apache-2.0
// The README's pictures of the report of the scene `paper`, by Chromium.   usage: draw.mjs PAGE [CHROMIUM]
import { createRequire } from 'node:module';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const { chromium } = createRequire(here('../viewer/package.json'))('playwright-core');
const browser = await chromium.launch({
  executablePath: process.argv[3] ?? process.env.POLHODE_CHROMIUM ?? '/usr/bin/chromium',
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const page = await (await browser.newContext({ viewport: { width: 1440, height: 1000 } })).newPage();
await page.goto(pathToFileURL(process.argv[2]).href);
await page.waitForSelector('main');

const save = (name, clip) => page.screenshot({ path: here(`${name}.png`), clip, fullPage: clip !== undefined });
const figure = (id) => page.locator(`[id="${id}"]`);
async function shown(id) {
  await figure(id).scrollIntoViewIfNeeded();
  await page.waitForTimeout(1500); // drawn when it comes near, then animated
}

/** The rectangle on the page that holds these figures, without what stands below the key of a plot. */
async function around(ids, bottom = '.legend') {
  for (const id of ids) await shown(id);
  const boxes = await page.evaluate(
    ([all, last]) =>
      all.map((id) => {
        const f = document.getElementById(id),
          outer = f.getBoundingClientRect(),
          end = (f.querySelector(last) ?? f).getBoundingClientRect();
        return [outer.left, outer.top + scrollY, outer.right, end.bottom + scrollY];
      }),
    [ids, bottom],
  );
  const side = (k, most) => most(...boxes.map((b) => b[k]));
  const [left, top, right, end] = [side(0, Math.min), side(1, Math.min), side(2, Math.max), side(3, Math.max)];
  return { x: left - 8, y: top - 8, width: right - left + 16, height: end - top + 10 };
}

await save('first_screen');
await page.addStyleTag({ content: '.bar { display: none }' }); // it sticks to the screen
await save('strong', await around(['strong.error.state']));
await save('weak', await around(['weak.error.energy', 'weak.error.pi1', 'weak.error.pi2', 'weak.error.pi3']));
await save('exponents', await around(['lyapunov.error.lambda-1', 'lyapunov.error.lambda-1-lambda-2']));
const modified = ['residual', 'error.inverse-inertia', 'error.dissipation', 'error.noise'];
await save('modified', await around(modified.map((name) => `modified.${name}`)));
await browser.close();
