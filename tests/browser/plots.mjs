// What a page has drawn, what the data says it must draw, and what a plot answers to the mouse.

/** Asks until the answer is yes. (Playwright's own waiting evaluates strings, which the page's policy forbids.) */
export async function until(ask, seconds = 20) {
  for (const end = Date.now() + 1000 * seconds; !(await ask()); ) {
    if (Date.now() > end) throw new Error(`waited ${seconds} s for ${ask}`);
    await new Promise((done) => setTimeout(done, 40));
  }
}

export const key = (m) => JSON.stringify([m.experiment, m.scheme, m.quantity, m.observable, m.dt, m.steps, m.value]);

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

/** From the data alone: values over dt or over steps, by what they are of. */
export function groupsIn(results) {
  const groups = new Map();
  for (const m of results.measurements) {
    if (m.value === null || (m.dt === null && m.steps === null)) continue;
    const name = JSON.stringify(
      /=/.test(m.observable) ? [m.experiment, m.quantity] : [m.experiment, m.quantity, m.observable],
    );
    groups.set(name, [...(groups.get(name) ?? []), m]);
  }
  return groups;
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
