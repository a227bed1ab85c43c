// SPDX-License-Identifier: Apache-2.0
// What a page has drawn, what the data says it must draw, and what a plot answers to the mouse.

/** Asks until the answer is yes. (Playwright's own waiting evaluates strings, which the page's policy forbids.) */
export async function until(ask, seconds = 20) {
  for (const end = Date.now() + 1000 * seconds; !(await ask()); ) {
    if (Date.now() > end) throw new Error(`waited ${seconds} s for ${ask}`);
    await new Promise((done) => setTimeout(done, 40));
  }
}

export const key = (m) =>
  JSON.stringify([
    m.experiment,
    m.scheme,
    m.quantity,
    m.observable,
    m.at.map((c) => [c.name, c.value]),
    m.value,
    m.low,
    m.high,
  ]);

/** Every measurement that stands behind a drawn item, with the figure it is drawn in. */
export function drawn(page) {
  return page.$$eval('figure.plot:not(.globe)', (figures) =>
    figures.flatMap((figure) =>
      figure.figure.chart
        .getOption()
        .series.flatMap((s) => s.data ?? [])
        .flatMap((d) => d?.item?.rows ?? [])
        .map((row) => ({ row, figure: figure.id })),
    ),
  );
}

const seriesKey = (experiment, s) => JSON.stringify([experiment, s.scheme, s.quantity, s.observable, s.over]);

/** From the data alone: the values that each curve and map must draw, by its id. */
export function valuesIn(results) {
  const values = results.measurements.filter((m) => m.value !== null),
    drawn = results.plots.filter((p) => p.kind === 'curve' || p.kind === 'map');
  return new Map(
    drawn.map((p) => {
      const own = new Set(p.lines.map((line) => seriesKey(p.experiment, line.series)));
      const axes = [p.x, p.y].filter((name) => name !== undefined);
      const has = (m, name) => m.at.some((c) => c.name === name);
      return [p.id, values.filter((m) => own.has(seriesKey(m.experiment, m)) && axes.every((name) => has(m, name)))];
    }),
  );
}

/** Values over an abscissa that no plot names. */
export function undescribed(results) {
  const named = new Set(
    results.plots.flatMap((p) =>
      p.lines.flatMap((line) =>
        [line.series, line.across, ...(line.beside ?? [])].filter(Boolean).map((s) => seriesKey(p.experiment, s)),
      ),
    ),
  );
  return results.measurements.filter(
    (m) => m.value !== null && m.over !== '' && !named.has(seriesKey(m.experiment, m)),
  );
}

/** All numbers of a text, as doubles. */
export const numbersIn = (text) => new Set((text.match(/-?\d+(\.\d+)?(e[-+]?\d+)?/gi) ?? []).map(Number));

/** Moves the mouse onto a point, and reads what appears. */
export async function tooltipAt(page, figure) {
  await until(() => figure.evaluate((f) => f.figure.chart !== null));
  const at = await figure.evaluate((f) => {
    const { chart } = f.figure,
      series = chart.getOption().series;
    const index = series.findIndex((s) => !s.silent && (s.data ?? []).some((d) => d?.item));
    const point = series[index].data.find((d) => d?.item && d.item.rows[0].value !== null);
    const [x, y] = chart.convertToPixel({ seriesIndex: index }, point.value),
      box = f.querySelector('.chart').getBoundingClientRect();
    return { x: box.left + x, y: box.top + y };
  });
  await page.mouse.move(at.x - 3, at.y - 3);
  await page.mouse.move(at.x, at.y);
  const tip = await figure.waitForSelector('.tip', { state: 'visible' });
  // Points may lie upon each other: whichever answers must tell a number of this plot, to the last digit.
  const text = await tip.innerText();
  const rows = await figure.evaluate((f) => f.figure.plot.rows);
  return {
    text,
    rows: rows.filter((m) => m.value !== null && text.startsWith(m.scheme) && numbersIn(text).has(m.value)),
  };
}
