// SPDX-License-Identifier: Apache-2.0
// The densities of an experiment: a globe that turns, its snapshots, a flat map beside it.
import type { Density } from '../data';
import { h, save, toggle, type Child } from '../dom';
import { shown, slug } from '../numbers';
import { permalink } from '../permalink';
import { watch } from '../watch';
import { scaleOver, type Scale } from './colours';
import { drawFlat, flatCanvas, flatSvg } from './flat';
import { colourBar, snapshots } from './legend';
import { densitiesCsv, densityTable, titleOf } from './numbers';
import { binOf, directionAt, mollweideAt, seen, type Vector, type View } from './sphere';
import { Globe } from './webgl';

const home: View = { longitude: 0.6, latitude: 0.45 };
const axes: [string, Vector][] = [
  ['Π₁', [1, 0, 0]],
  ['Π₂', [0, 1, 0]],
  ['Π₃', [0, 0, 1]],
  ['−Π₁', [-1, 0, 0]],
  ['−Π₂', [0, -1, 0]],
  ['−Π₃', [0, 0, -1]],
];
const turn = Math.PI / 24;

export class GlobeFigure {
  readonly element: HTMLElement;
  private readonly id: string;
  private readonly scale: Scale;
  private readonly round = h('canvas', { class: 'round' });
  private readonly flat = h('canvas', { class: 'flat' });
  private readonly stage: HTMLElement;
  private readonly labels = axes.map(([name]) => h('span', { class: 'axis', 'aria-hidden': 'true' }, name));
  private readonly readout = h('output', { class: 'readout' }, ' ');
  private readonly caption = h('span', {});
  private readonly printed = h('div', { class: 'printed snapshots' });
  private readonly globe: Globe | null;
  private flatChosen: boolean;
  private view: View = { ...home };
  private current = 0;

  constructor(
    private readonly experiment: string,
    private readonly densities: Density[],
  ) {
    this.id = slug(experiment, 'densities');
    this.scale = scaleOver(densities);
    this.globe = Globe.on(this.round);
    this.flatChosen = this.globe === null;
    this.stage = h('div', { class: 'stage', tabindex: 0, role: 'img' }, this.round, this.flat, ...this.labels);
    this.element = h(
      'figure',
      { id: this.id, class: 'plot globe', 'data-points': densities.reduce((n, d) => n + d.values.length, 0) },
      h('figcaption', {}, this.caption, permalink(this.id, 'Link to this globe', 'Link to this globe')),
      snapshots(densities, (index) => this.choose(index)),
      this.stage,
      this.readout,
      colourBar(this.scale),
      this.printed,
      this.tools(),
      densityTable(this.densities),
    );
    Object.defineProperty(this.element, 'figure', { value: this });
    this.listen();
    this.choose(0);
    watch(
      this.element,
      (near) => near && this.draw(),
      () => this.draw(),
    );
  }

  private get density(): Density {
    return this.densities[this.current] as Density;
  }

  private choose(index: number): void {
    this.current = index;
    this.globe?.load(this.density, this.scale);
    this.caption.textContent = `Density on the sphere: ${titleOf(this.density)}`;
    this.stage.setAttribute(
      'aria-label',
      `${this.caption.textContent}. Arrow keys turn the globe; the table below tells its range.`,
    );
    this.draw();
  }

  private draw(): void {
    const width = Math.min(this.element.clientWidth || 520, 520),
      flat = this.flatChosen;
    this.stage.classList.toggle('is-flat', flat);
    if (flat) {
      const sharp = Math.round(Math.min(2, devicePixelRatio) * width);
      Object.assign(this.flat, { width: sharp, height: Math.round(sharp / 2) });
      drawFlat(this.flat, this.density, this.scale);
      return;
    }
    const size = Math.round(Math.min(2, devicePixelRatio) * Math.min(width, 440));
    if (this.round.width !== size) Object.assign(this.round, { width: size, height: size });
    this.globe?.draw(this.view);
    axes.forEach(([, direction], i) => {
      const { u, v, front } = seen(this.view, direction),
        label = this.labels[i];
      if (!label) return;
      label.hidden = !front;
      label.style.left = `${50 + 48 * u}%`;
      label.style.top = `${50 - 48 * v}%`;
    });
  }

  private rotate(dx: number, dy: number): void {
    this.view.longitude -= dx;
    this.view.latitude = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, this.view.latitude + dy));
    this.draw();
  }

  private listen(): void {
    let from: [number, number] | null = null;
    this.stage.addEventListener('pointerdown', (event) => {
      from = [event.clientX, event.clientY];
      this.stage.setPointerCapture(event.pointerId);
    });
    this.stage.addEventListener('pointerup', () => (from = null));
    this.stage.addEventListener('pointercancel', () => (from = null));
    this.stage.addEventListener('pointermove', (event) => {
      if (from && !this.flatChosen) {
        const radius = this.round.clientWidth / 2 || 1;
        this.rotate((event.clientX - from[0]) / radius, (event.clientY - from[1]) / radius);
        from = [event.clientX, event.clientY];
      }
      this.tell(event);
    });
    this.stage.addEventListener('keydown', (event) => {
      const by = (
        { ArrowLeft: [turn, 0], ArrowRight: [-turn, 0], ArrowUp: [0, turn], ArrowDown: [0, -turn] } as Record<
          string,
          [number, number]
        >
      )[event.key];
      if (!by || this.flatChosen) return;
      event.preventDefault();
      this.rotate(...by);
    });
  }

  private tell(event: PointerEvent): void {
    const canvas = this.flatChosen ? this.flat : this.round,
      box = canvas.getBoundingClientRect();
    const u = ((event.clientX - box.left) / box.width) * 2 - 1,
      v = 1 - ((event.clientY - box.top) / box.height) * 2;
    const n = this.flatChosen ? mollweideAt(u, v) : directionAt(this.view, 1.04 * u, 1.04 * v);
    this.readout.textContent =
      n === null
        ? ' '
        : `Π/c = (${n.map((x) => x.toFixed(2)).join(', ')}): ${shown(this.density.values[binOf(this.density, n)] ?? null)} × uniform`;
  }

  private tools(): Child {
    const name = (): string => slug(this.id, titleOf(this.density));
    const tool = (label: string, action: () => void): Child => h('button', { type: 'button', click: action }, label);
    const shape = toggle(
      'flat',
      () => this.flatChosen,
      () => {
        this.flatChosen = !this.flatChosen;
        this.draw();
      },
    );
    return h(
      'div',
      { class: 'tools' },
      this.globe ? shape : h('span', { class: 'note' }, 'No WebGL here: the flat map of equal area.'),
      this.globe !== null &&
        tool('reset', () => {
          this.view = { ...home };
          this.draw();
        }),
      h('span', { class: 'gap' }),
      tool('SVG', () => save(`${name()}.svg`, this.toSvg(), 'image/svg+xml')),
      tool('PNG', () =>
        (this.flatChosen ? this.flat : this.round).toBlob((blob) => blob && save(`${name()}.png`, blob)),
      ),
      tool('CSV', () => save(`${this.id}.csv`, densitiesCsv(this.densities), 'text/csv')),
    );
  }

  toSvg(): string {
    return flatSvg(this.density, this.scale, `${this.experiment}: ${titleOf(this.density)}`);
  }

  print(): void {
    this.printed.replaceChildren(
      ...this.densities.map((d) => h('figure', {}, h('figcaption', {}, titleOf(d)), flatCanvas(d, this.scale, 600))),
    );
  }

  unprint(): void {
    this.printed.replaceChildren();
  }
}
