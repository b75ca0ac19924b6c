type Content = Node | string | null;

type Attributes = Readonly<Record<string, string | number | boolean | ((event: Event) => void)>>;

/**
 * Creates an element.
 * @param attributes functions are listeners (`click`), `false` leaves an attribute out
 */
export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...content: readonly Content[]
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') made.addEventListener(name, value);
    else if (value !== false) made.setAttribute(name, value === true ? '' : String(value));
  }
  made.append(...content.filter((part) => part !== null));
  return made;
}

// strokes in a square of 24
const ICONS = {
  again: 'M4 12a8 8 0 1 0 2.5-5.8M4 4v5h5',
  copy: 'M9 9h11v11H9zM5 15H4V4h11v1',
  ghost: 'M5 21V11a7 7 0 0 1 14 0v10l-2.3-2-2.4 2-2.3-2-2.3 2-2.4-2zM9.5 11v.5M14.5 11v.5',
  levels: 'M4 4h6v6H4zM14 4h6v6h-6zM4 14h6v6H4zM14 14h6v6h-6z',
  link: 'M10 14a4 4 0 0 0 6 .5l3-3a4 4 0 0 0-6-6l-1 1M14 10a4 4 0 0 0-6-.5l-3 3a4 4 0 0 0 6 6l1-1',
  lock: 'M6 11h12v9H6zM8.5 11V8a3.5 3.5 0 0 1 7 0v3',
  next: 'M6 5l9 7-9 7zM18.5 5v14',
  open: 'M12 16V4M7 9l5-5 5 5M4 16v4h16v-4',
  pause: 'M8 5v14M16 5v14',
  play: 'M7 4.5l12 7.5-12 7.5z',
  save: 'M12 4v12M7 11l5 5 5-5M4 16v4h16v-4',
  silent: 'M4 9v6h4l5 4V5L8 9zM16.5 9.5l5 5M21.5 9.5l-5 5',
  sound: 'M4 9v6h4l5 4V5L8 9zM16.5 9a4.5 4.5 0 0 1 0 6M19 6.5a8 8 0 0 1 0 11',
  warning: 'M12 4L2.5 20h19zM12 10v4M12 17v.2',
  watch: 'M2 12s3.5-6.5 10-6.5S22 12 22 12s-3.5 6.5-10 6.5S2 12 2 12zM12 9.2a2.8 2.8 0 1 0 .01 0z',
} as const;

export type IconName = keyof typeof ICONS;

const SVG = 'http://www.w3.org/2000/svg';

/** A small picture without a meaning of its own: the text beside it, or the label of its button, says it. */
export function icon(name: IconName): SVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('class', 'icon');
  const path = document.createElementNS(SVG, 'path');
  path.setAttribute('d', ICONS[name]);
  svg.append(path);
  return svg;
}

/** A button with an icon alone. */
export function iconButton(name: IconName, label: string, click: () => void, key?: string): HTMLButtonElement {
  const title = key === undefined ? label : `${label} (${key})`;
  return element('button', { type: 'button', class: 'icon-button', 'aria-label': label, title, click }, icon(name));
}

/** A button with an icon and its text. */
export function textButton(name: IconName, text: string, click: () => void, kind = ''): HTMLButtonElement {
  return element('button', { type: 'button', class: `text-button ${kind}`, click }, icon(name), element('span', {}, text));
}
