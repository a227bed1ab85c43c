// A plot on the page: drawn when it comes near the screen, with its key, its switches, its files and its table.
import { csvOf } from './csv';
import type { Measurement } from './data';
import { h, save, type Child } from './dom';
import { keySample } from './key';
import { slug } from './numbers';
import { measurementTable } from './page/tables';
import { echarts, type Chart } from './plots/charts';
import { heightOf, optionOf } from './plots/draw';
import { earlierPointsIn, pointsIn, schemesIn, type Plot } from './plots/model';
import { pictureWidth, pngPicture, svgPicture } from './plots/picture';
import { hasManyPoints, lookIn, type Setting } from './plots/setting';
import { walker } from './plots/walker';
import { addressOf, goTo, isolate, isolated, on, theme } from './state';
import { papers } from './style';
import { watch } from './watch';

const printWidth = 560,
  broadPrintWidth = 1060;

/** Needs the whole width of the page. */
const isWide = (plot: Plot): boolean =>
  (plot.kind === 'map' && plot.panels.length > 1) || (plot.kind === 'matrix' && plot.columns.length > 6);

export class Figure {
  readonly element: HTMLElement;
  /** For the tests and for the console. */
  chart: Chart | null = null;
  private readonly canvas = h('div', { class: 'chart', tabindex: 0, role: 'img' });
  private readonly printed = h('div', { class: 'printed', 'aria-hidden': 'true' });
  private readonly keys: [string, HTMLButtonElement][] = [];
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
    this.canvas.setAttribute('aria-label', this.spoken());
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
      h('figcaption', {}, plot.title, this.permalink()),
      this.canvas,
      this.printed,
      this.legend(),
      this.remarks(),
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

  private spoken(): string {
    const schemes = schemesIn(this.plot).length;
    return (
      `${this.plot.title}: ${pointsIn(this.plot)} values${schemes > 0 ? ` of ${schemes} schemes` : ''}. ` +
      'Arrow keys go from point to point; the table below holds every number.'
    );
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
    for (const [scheme, key] of this.keys) {
      key.setAttribute('aria-pressed', String(scheme === isolated()));
      key.classList.toggle('faded', isolated() !== null && scheme !== isolated());
      key.replaceChildren(...keySample(lookIn(this.setting(false, 0), scheme), scheme));
    }
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

  private permalink(): Child {
    return h(
      'a',
      {
        class: 'permalink',
        href: addressOf(this.plot.id),
        title: 'Link to this plot',
        'aria-label': `Link to ${this.plot.title}`,
        click: (event) => {
          event.preventDefault();
          goTo(this.plot.id);
        },
      },
      '#',
    );
  }

  private legend(): Child {
    if (this.plot.kind !== 'curve') return false;
    for (const scheme of schemesIn(this.plot)) {
      const key = h(
        'button',
        {
          type: 'button',
          class: 'key-entry',
          'aria-pressed': 'false',
          title: `Only ${scheme}, in every plot`,
          click: () => isolate(scheme),
        },
        ...keySample(lookIn(this.setting(false, 0), scheme), scheme),
      );
      this.keys.push([scheme, key]);
    }
    return (
      this.keys.length > 0 &&
      h('div', { class: 'legend', role: 'group', 'aria-label': 'Schemes' }, ...this.keys.map(([, key]) => key))
    );
  }

  private remarks(): Child {
    const parts: Child[] = [],
      { plot } = this;
    if (plot.kind === 'curve' && plot.hollow !== '') parts.push(`Hollow: ${plot.hollow}. `);
    if (plot.kind === 'curve' && plot.lines.some((l) => l.fit))
      parts.push('Wide line: the fitted power law; its wedge is the interval of the order. ');
    if (earlierPointsIn(plot) > 0) parts.push('Faint: the earlier run. ');
    if (plot.kind === 'curve' && hasManyPoints(plot)) parts.push(`${pointsIn(plot)} points: drawn without bars. `);
    parts.push(plot.note);
    return parts.join('') !== '' && h('p', { class: 'note' }, ...parts);
  }

  private toggle(name: string, get: () => boolean, set: (next: boolean) => void): Child {
    const button = h(
      'button',
      {
        type: 'button',
        'aria-pressed': String(get()),
        click: () => {
          set(!get());
          button.setAttribute('aria-pressed', String(get()));
          this.stale = true;
          this.draw();
        },
      },
      name,
    );
    return button;
  }

  /** CPU time, or what is counted. */
  private ordinates(): Child[] {
    const { plot } = this;
    if (plot.kind !== 'curve' || !plot.others || plot.others.length === 0) return [];
    const choices: [string, Plot][] = [['time', plot], ...plot.others.map((o): [string, Plot] => [o.name, o.plot])];
    const buttons = choices.map(([name, choice]) => {
      const pressed = String(choice === plot);
      return h('button', { type: 'button', 'aria-pressed': pressed, click: () => choose(choice) }, name);
    });
    const choose = (choice: Plot): void => {
      this.current = choice;
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(choices[i]?.[1] === choice)));
      this.draw();
    };
    return [h('span', { class: 'soft small' }, 'cost in'), ...buttons];
  }

  private tools(): Child {
    const { plot } = this,
      name = slug(plot.id);
    const tool = (label: string, action: () => void): Child => h('button', { type: 'button', click: action }, label);
    return h(
      'div',
      { class: 'tools' },
      plot.kind !== 'matrix' &&
        this.toggle(
          'log x',
          () => this.logX,
          (next) => (this.logX = next),
        ),
      (plot.kind === 'curve' || plot.kind === 'map') &&
        this.toggle(
          'log y',
          () => this.logY,
          (next) => (this.logY = next),
        ),
      earlierPointsIn(plot) > 0 &&
        this.toggle(
          'earlier run',
          () => this.earlier,
          (next) => (this.earlier = next),
        ),
      ...this.ordinates(),
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
    const details = h(
      'details',
      {
        class: 'behind',
        toggle: () => {
          if (details.open && details.children.length === 1)
            details.append(measurementTable(this.plot.rows, this.earlierRows()));
        },
      },
      h('summary', {}, `The ${this.plot.rows.length + (this.earlierRows()?.length ?? 0)} numbers behind this plot`),
    );
    return details;
  }

  print(): void {
    const picture = new DOMParser().parseFromString(
      this.toSvg(isWide(this.plot) ? broadPrintWidth : printWidth),
      'image/svg+xml',
    ).documentElement;
    picture.removeAttribute('width');
    picture.removeAttribute('height');
    this.printed.replaceChildren(document.importNode(picture, true));
  }

  unprint(): void {
    this.printed.replaceChildren();
  }
}
