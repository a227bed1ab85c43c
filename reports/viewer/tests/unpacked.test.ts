// SPDX-License-Identifier: Apache-2.0
import { deflateSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { canUnpack, unpacked } from '../src/unpacked';

const text = '{"scene":{"name":"</script>🌀\u2028"}}'.repeat(1000),
  packed = deflateSync(text).toString('base64');

test('what was packed comes back', async () => {
  expect(canUnpack()).toBe(true);
  expect(await unpacked(packed)).toBe(text);
  expect(await unpacked('')).toBe('');
});

test('what is cut short or changed is refused in one line', async () => {
  for (const bad of [packed.slice(0, 100), packed.slice(0, -8), `A${packed.slice(1)}`, '{"scene":{}}'])
    await expect(unpacked(bad)).rejects.toThrow(/^These results cannot be read[^\n]*$/);
});
