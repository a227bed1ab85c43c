// SPDX-License-Identifier: Apache-2.0
// The same density on Mollweide's map: where there is no WebGL, on paper, and in files.
import type { Density } from '../data';
import { h, svg } from '../dom';
import { shown } from '../numbers';
import { ramp, viridis, type Scale } from './colours';
import { binOf, mollweideAt, mollweideOf } from './sphere';

export function drawFlat(canvas: HTMLCanvasElement, d: Density, scale: Scale): void {
  const { width, height } = canvas,
    context = canvas.getContext('2d');
  if (!context || width === 0 || height === 0) return;
  const image = context.createImageData(width, height);
  for (let j = 0; j < height; ++j)
    for (let i = 0; i < width; ++i) {
      const n = mollweideAt((2 * i + 1) / width - 1, 1 - (2 * j + 1) / height);
      if (!n) continue;
      const value = d.values[binOf(d, n)] ?? null,
        at = 4 * (j * width + i);
      image.data.set(value === null ? [128, 128, 128] : viridis(scale.share(value)), at);
      image.data[at + 3] = 255;
    }
  context.putImageData(image, 0, 0);
}

export function flatCanvas(d: Density, scale: Scale, width: number): HTMLCanvasElement {
  const canvas = h('canvas', { width, height: width / 2 });
  drawFlat(canvas, d, scale);
  return canvas;
}

function graticule(x: (a: number) => number, y: (b: number) => number): string {
  const path: string[] = [],
    along = Array.from({ length: 37 }, (_, i) => -1 + i / 18);
  for (let k = -5; k <= 5; ++k) {
    const meridian = along.map((t) => mollweideOf((k * Math.PI) / 6, (t * Math.PI) / 2));
    path.push('M' + meridian.map(([a, b]) => `${x(a).toFixed(1)} ${y(b).toFixed(1)}`).join('L'));
  }
  for (let k = -2; k <= 2; ++k) {
    const [end, b] = mollweideOf(Math.PI, (k * Math.PI) / 6);
    path.push(`M${x(-end).toFixed(1)} ${y(b).toFixed(1)}L${x(end).toFixed(1)} ${y(b).toFixed(1)}`);
  }
  return path.join('');
}

/** A picture that stands alone: the map as an image, net, names and colour bar as lines and text. */
export function flatSvg(d: Density, scale: Scale, title: string): string {
  const width = 820,
    x = (a: number): number => 410 + 380 * a,
    y = (b: number): number => 240 - 190 * b;
  const text = (at: [number, number], content: string, size = 13, anchor = 'middle'): SVGElement =>
    svg('text', { x: at[0], y: at[1], 'font-size': size, 'text-anchor': anchor, fill: '#1f2328' }, content);
  const names: [string, number, number][] = [
    ['Π₁', 0, 0],
    ['Π₂', Math.PI / 2, 0],
    ['−Π₂', -Math.PI / 2, 0],
    ['Π₃', 0, Math.PI / 2],
    ['−Π₃', 0, -Math.PI / 2],
  ];
  const picture = svg(
    'svg',
    { viewBox: `0 0 ${width} 500`, width, height: 500, 'font-family': 'system-ui, sans-serif' },
    svg('rect', { width, height: 500, fill: '#ffffff' }),
    text([20, 28], title, 15, 'start'),
    svg('image', { x: 30, y: 50, width: 760, height: 380, href: flatCanvas(d, scale, 1140).toDataURL('image/png') }),
    svg('path', { d: graticule(x, y), fill: 'none', stroke: '#ffffff', 'stroke-opacity': 0.35, 'stroke-width': 0.8 }),
    ...names.map(([name, longitude, latitude]) => {
      const [a, b] = mollweideOf(longitude, latitude);
      return svg(
        'text',
        {
          x: x(a),
          y: y(b) + (latitude > 0 ? -4 : latitude < 0 ? 14 : 4),
          'font-size': 13,
          'text-anchor': 'middle',
          fill: latitude === 0 ? '#ffffff' : '#1f2328',
        },
        name,
      );
    }),
    ...ramp(64).map((fill, i) => svg('rect', { x: 250 + 5 * i, y: 452, width: 5.5, height: 12, fill })),
    text([242, 463], shown(scale.low, 2), 12, 'end'),
    text([578, 463], shown(scale.high, 2), 12, 'start'),
    text([410, 484], 'density relative to uniform', 12),
  );
  return new XMLSerializer().serializeToString(picture);
}
