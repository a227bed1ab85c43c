// SPDX-License-Identifier: Apache-2.0
// Elements by hand: text is only ever set as text.

export type Child = Node | string | number | null | undefined | false;
type Attributes = Record<string, string | number | boolean | null | undefined | ((event: Event) => void)>;

function fill<Made extends Element>(element: Made, attributes: Attributes, children: Child[]): Made {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (value !== null && value !== undefined && value !== false)
      element.setAttribute(name, value === true ? '' : String(value));
  }
  for (const child of children)
    if (child !== null && child !== undefined && child !== false)
      element.append(typeof child === 'number' ? String(child) : child);
  return element;
}

/** A function among the attributes listens to the event of that name. */
export function h<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  return fill(document.createElement(tag), attributes, children);
}

export function svg(tag: string, attributes: Attributes = {}, ...children: Child[]): SVGElement {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

/** A button that is pressed or not. */
export function toggle(name: string, pressed: () => boolean, turn: () => void): HTMLButtonElement {
  const button = h(
    'button',
    {
      type: 'button',
      'aria-pressed': String(pressed()),
      click: () => {
        turn();
        button.setAttribute('aria-pressed', String(pressed()));
      },
    },
    name,
  );
  return button;
}

/** Details that are made when they are first looked at. */
export function lazily(summary: string, make: () => Node, attributes: Attributes = {}): HTMLElement {
  const details = h(
    'details',
    {
      ...attributes,
      toggle: () => {
        if (details.open && details.children.length === 1) details.append(make());
      },
    },
    h('summary', {}, summary),
  );
  if (details.open) details.append(make());
  return details;
}

/** Gives text or bytes to the reader as a file. */
export function save(name: string, content: string | Blob, type = 'text/plain'): void {
  const blob = typeof content === 'string' ? new Blob([content], { type: `${type};charset=utf-8` }) : content;
  const link = h('a', { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
