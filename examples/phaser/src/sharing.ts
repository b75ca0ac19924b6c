import { encodePlay, type Player, playOf, playToText } from 'gravity-quest-toolkit/game';
import { element, textButton } from './dom.ts';

/** ms: the browser has read a download by then. */
const DOWNLOADED = 10_000;

function download(bytes: Uint8Array, name: string): void {
  const url = URL.createObjectURL(new Blob([bytes.slice()], { type: 'application/octet-stream' }));
  element('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), DOWNLOADED);
}

async function copy(text: string, said: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    said.textContent = 'Copied.';
  } catch {
    // some browsers refuse the clipboard, for example on a page from a file
    const area = element('textarea', { readonly: true, rows: 3, 'aria-label': 'Text to copy' });
    area.value = text;
    said.replaceChildren('The browser refuses the clipboard. Copy it from here:', area);
    area.select();
  }
}

/**
 * Ways to keep a play or to send it.
 * @param linkTo makes the address of this page with the text of a play
 */
export function shareButtons(player: Player, name: string, linkTo: (text: string) => string): HTMLElement[] {
  const bytes = encodePlay(playOf(player));
  const text = playToText(bytes);
  const said = element('p', { class: 'said', role: 'status' });
  const row = element(
    'div',
    { class: 'share' },
    textButton('save', 'Save this play', () => download(bytes, `${name}.gqr`), 'quiet'),
    textButton('copy', 'Copy as text', () => void copy(text, said), 'quiet'),
    textButton('link', 'Copy a link', () => void copy(linkTo(text), said), 'quiet'),
  );
  return [row, said];
}
