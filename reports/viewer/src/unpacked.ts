// SPDX-License-Identifier: Apache-2.0
// The texts that the program has packed into the page: compressed by zlib, in base64.

export const canUnpack = (): boolean => 'DecompressionStream' in globalThis;

/** Nothing where nothing was packed. Throws an Error of one line where the page was cut short or changed. */
export async function unpacked(packed: string): Promise<string> {
  if (packed === '') return '';
  try {
    const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
    const text = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    return await new Response(text).text();
  } catch {
    throw new Error(
      `These results cannot be read: not packed as this page packs them, or cut short (${packed.length} characters).`,
    );
  }
}
