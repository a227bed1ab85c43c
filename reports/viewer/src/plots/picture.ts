// SPDX-License-Identifier: Apache-2.0
// A plot as a picture that stands alone: as light as paper, with title and key.
import { h } from '../dom';
import { echarts } from './charts';
import { heightOf, optionOf } from './draw';
import type { Plot } from './model';
import type { Setting } from './setting';

export const pictureWidth = 820,
  printWidth = 560,
  broadPrintWidth = 1060;

export function svgPicture(plot: Plot, setting: Setting): string {
  const size = { width: setting.width, height: heightOf(plot, setting) };
  const chart = echarts.init(null, null, { renderer: 'svg', ssr: true, ...size });
  chart.setOption(optionOf(plot, setting));
  const picture = chart.renderToSVGString();
  chart.dispose();
  return picture;
}

export function pngPicture(plot: Plot, setting: Setting, take: (picture: Blob) => void): void {
  const size = { width: setting.width, height: heightOf(plot, setting) };
  const chart = echarts.init(h('div'), null, { renderer: 'canvas', devicePixelRatio: 2, ...size });
  chart.setOption(optionOf(plot, setting));
  const canvas = chart.renderToCanvas({ pixelRatio: 2, backgroundColor: setting.paper.card });
  canvas.toBlob((blob) => blob && take(blob));
  chart.dispose();
}

/** A picture as a part of the page, as wide as its place. */
export function paperPicture(svg: string): Node {
  const picture = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
  picture.removeAttribute('width');
  picture.removeAttribute('height');
  return document.importNode(picture, true);
}
