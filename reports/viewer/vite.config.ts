import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

// One file, in ASCII, the same from the same sources: it is committed, and put into the program.
export default defineConfig({
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  esbuild: { charset: 'ascii', legalComments: 'none' },
  build: {
    target: 'es2022', outDir: 'dist', emptyOutDir: true, minify: 'esbuild', cssMinify: true, sourcemap: false,
    rollupOptions: { input: 'report.html' },
  },
});
