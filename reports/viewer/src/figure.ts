// SPDX-License-Identifier: Apache-2.0
// A plot on the page: drawn when it comes near the screen, with its key, its switches, its files and its table.
import { csvOf } from './csv';
import type { Measurement } from './data';
import { h, lazily, save, toggle, type Child } from './dom';
import { Legend } from './legend';
import { slug } from './numbers';
import { measurementTable } from './page/result_tables';
import { permalink } from './permalink';
import { echarts, type Chart } from './plots/charts';
import { heightOf, optionOf } from './plots/draw';
import { earlierPointsIn, isWide, pointsIn, schemesIn, type Plot } from './plots/model';
import { ordinates } from './plots/ordinates';
import { broadPrintWidth, paperPicture, pictureWidth, pngPicture, printWidth, svgPicture } from './plots/picture';
import { remarks, spoken } from './plots/remarks';
import { hasManyPoints, lookIn, type Setting } from './plots/setting';
import { walker } from './plots/walker';
import { isolated, on, theme } from './state';
import { papers } from './style';
import { watch } from './watch';

export class Figure {
  readonly element: HTMLElement;
  /** For the tests and for the console. */
  chart: Chart | null = null;
  private readonly canvas = h('div', { class: 'chart', tabindex: 0, role: 'img' });
  private readonly printed = h('div', { class: 'printed', 'aria-hidden': 'true' });
  private readonly legend: Legend;
  private current: Plot; // the plot itself, or the same points over another ordinate
  private logX: boolean;
  private logY: boolean;
  private earlier = true;
  private stale = true;
  private near = false;

  constructor(
    readonly plot: Plot,
    private readonly schemes: readonly string[],
  ) {
    this.current = plot;
    this.logX = plot.kind === 'matrix' ? false : plot.logX;
    this.logY = plot.kind === 'curve' || plot.kind === 'map' ? plot.logY : false;
    this.legend = new Legend(plot.kind === 'curve' ? schemesIn(plot) : [], (scheme) =>
      lookIn(this.setting(false, 0), scheme),
    );
    this.canvas.setAttribute('aria-label', spoken(plot));
    this.canvas.addEventListener(
      'keydown',
      walker(() => this.chart),
    );
    this.element = h(
      'figure',
      {
        id: plot.id,
        class: `plot ${plot.kind}${isWide(plot) ? ' broad' : ''}`,
        'data-points': pointsIn(plot),
        'data-earlier-points': earlierPointsIn(plot) || null,
      },
      h('figcaption', {}, plot.title, permalink(plot.id, 'Link to this plot', `Link to ${plot.title}`)),
      this.canvas,
      this.printed,
      this.legend.element(),
      remarks(plot),
      this.tools(),
      this.table(),
    );
    Object.defineProperty(this.element, 'figure', { value: this });
    this.reserve();
    watch(
      this.element,
      (near) => this.come(near),
      () => this.resize(),
    );
    on('scheme', () => this.refresh());
    on('theme', () => this.refresh());
  }

  setting(standalone: boolean, width: number): Setting {
    return {
      paper: papers[standalone ? 'light' : theme()],
      width,
      schemes: this.schemes,
      isolated: isolated(),
      logX: this.logX,
      logY: this.logY,
      earlier: this.earlier,
      standalone,
    };
  }

  private reserve(): void {
    this.canvas.style.height = `${heightOf(this.plot, this.setting(false, this.canvas.clientWidth || 520))}px`;
  }

  private come(near: boolean): void {
    this.near = near;
    if (near && this.stale) this.draw();
  }

  private refresh(): void {
    this.stale = true;
    this.legend.refresh();
    if (this.near) this.draw();
  }

  private resize(): void {
    if (!this.chart) return this.reserve();
    if (this.chart.getWidth() === this.canvas.clientWidth || this.canvas.clientWidth === 0) return;
    this.stale = true;
    if (this.near) this.draw();
  }

  draw(): void {
    const width = this.canvas.clientWidth;
    if (width === 0) return;
    const setting = this.setting(false, width),
      height = heightOf(this.plot, setting);
    this.canvas.style.height = `${height}px`;
    this.chart ??= echarts.init(this.canvas, null, {
      renderer: hasManyPoints(this.plot) ? 'canvas' : 'svg',
      width,
      height,
    });
    this.chart.resize({ width, height });
    this.chart.clear(); // parts of what was drawn before would stay
    this.chart.setOption(optionOf(this.current, setting));
    this.stale = false;
  }

  private switchOf(name: string, which: 'logX' | 'logY' | 'earlier'): Child {
    return toggle(
      name,
      () => this[which],
      () => {
        this[which] = !this[which];
        this.stale = true;
        this.draw();
      },
    );
  }

  private over(choice: Plot): void {
    this.current = choice;
    this.draw();
  }

  private tools(): Child {
    const { plot } = this,
      name = slug(plot.id);
    const tool = (label: string, action: () => void): Child => h('button', { type: 'button', click: action }, label);
    return h(
      'div',
      { class: 'tools' },
      plot.kind !== 'matrix' && this.switchOf('log x', 'logX'),
      (plot.kind === 'curve' || plot.kind === 'map') && this.switchOf('log y', 'logY'),
      earlierPointsIn(plot) > 0 && this.switchOf('earlier run', 'earlier'),
      ...ordinates(plot, (choice) => this.over(choice)),
      h('span', { class: 'gap' }),
      tool('SVG', () => save(`${name}.svg`, this.toSvg(), 'image/svg+xml')),
      tool('PNG', () =>
        pngPicture(this.current, this.setting(true, pictureWidth), (picture) => save(`${name}.png`, picture)),
      ),
      tool('CSV', () => save(`${name}.csv`, csvOf(plot.rows, this.earlierRows()), 'text/csv')),
    );
  }

  toSvg(width = pictureWidth): string {
    return svgPicture(this.current, this.setting(true, width));
  }

  private earlierRows(): Measurement[] | null {
    return (this.plot.kind === 'curve' && this.plot.earlier?.rows) || null;
  }

  private table(): Child {
    const { rows } = this.plot,
      earlier = this.earlierRows();
    return lazily(
      `The ${rows.length + (earlier?.length ?? 0)} numbers behind this plot`,
      () => measurementTable(rows, earlier),
      { class: 'behind' },
    );
  }

  print(): void {
    this.printed.replaceChildren(paperPicture(this.toSvg(isWide(this.plot) ? broadPrintWidth : printWidth)));
  }

  unprint(): void {
    this.printed.replaceChildren();
  }
}
