// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { defineConfig, type Plugin } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

/** What the page is partly made of, with the licences under which it is passed on. */
function notices(): Plugin {
  const text = (path: string): string => readFileSync(new URL(`node_modules/${path}`, import.meta.url), 'utf8').trim();
  const parts = [
    'This page contains Apache ECharts (Apache License 2.0, https://www.apache.org/licenses/LICENSE-2.0), and with it zrender, d3 and tslib.',
    text('echarts/NOTICE'),
    `zrender: ${text('zrender/LICENSE')}`,
    `d3: ${text('echarts/licenses/LICENSE-d3')}`,
    `tslib: ${text('tslib/LICENSE.txt')}`,
  ];
  const comment = parts.join('\n\n').replace(/\r/g, '').replace(/--/g, '- -');
  return {
    name: 'notices',
    transformIndexHtml: {
      order: 'post',
      handler: (html) => html.replace('</head>', () => `<!--\n${comment}\n-->\n</head>`),
    },
  };
}

// One file, in ASCII, the same from the same sources: it is committed, and put into the program.
export default defineConfig({
  plugins: [notices(), viteSingleFile({ removeViteModuleLoader: true })],
  esbuild: { charset: 'ascii', legalComments: 'none' },
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: true,
    minify: 'esbuild',
    cssMinify: true,
    sourcemap: false,
    rollupOptions: { input: 'report.html' },
  },
});
