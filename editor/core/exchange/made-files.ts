import { sha256 } from '@noble/hashes/sha2.js';
import { PACK_FILE, type Pack, packScript, pageOf } from '../../../check/pack/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import type { LiveProof } from '../proof/index.ts';

// files that are made of levels: pages and pictures

/** The game as it was built: its page, and the scripts that the page loads, by the address that it uses. */
export interface BuiltGame {
  readonly page: string;
  readonly scripts: ReadonlyMap<string, string>;
}

const SCRIPT = /<script\b[^>]*\bsrc="([^"]+)"[^>]*><\/script>\s*/g;

/**
 * Fetches the game that comes with this page.
 * @param folder its address
 * @throws (rejects) in words if it is not there
 */
export async function fetchGame(folder: string, get: typeof fetch = fetch): Promise<BuiltGame> {
  const text = async (name: string): Promise<string> => {
    const response = await get(new URL(name, folder)).catch(() => null);
    if (response?.ok) return response.text();
    const why = response === null ? 'no answer' : `status ${response.status}`;
    throw new Error(`the game that comes with the editor can't be read (${name}: ${why})`);
  };
  const page = await text('index.html');
  const names = [...page.matchAll(SCRIPT)].map(([, name]) => name).filter((name) => !name.endsWith(PACK_FILE));
  const scripts = await Promise.all(names.map(async (name) => [name, await text(name)] as const));
  return { page, scripts: new Map(scripts) };
}

/** A script as the text of an element: nothing in it ends the element, or begins a comment of HTML. */
const inElement = (script: string): string => script.replace(/<(?=!--|\/script)/gi, '\\x3C').replaceAll('\r\n', '\n');

/** A policy that lets only these scripts run. */
function policyOf(scripts: readonly string[]): string {
  const hashes = scripts.map((text) => `'sha256-${btoa(String.fromCharCode(...sha256(new TextEncoder().encode(text))))}'`);
  return [
    "default-src 'none'",
    `script-src ${hashes.join(' ')}`,
    "style-src 'unsafe-inline'",
    'img-src data: blob:',
    'media-src data: blob:',
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

/** One file that contains a page, its game and a pack. It needs nothing else, wherever it lies. */
export function singlePage({ page, scripts }: BuiltGame, pack: Pack): string {
  const texts = [packScript(pack), ...scripts.values()].map(inElement);
  const bare = pageOf(page, pack.title, policyOf(texts)).replace(SCRIPT, '');
  // the elements that a script looks for stand before it
  const elements = texts.map((text) => `<script>${text}</script>\n`).join('');
  return bare.replace(/(?=<\/body>)/, () => elements);
}

interface PictureOptions {
  readonly theme: 'dark' | 'light';
  /** px */
  readonly width: number;
  readonly withRun: boolean;
}

/** A picture of the level, with the shown run if wanted. */
export function pictureSvg({ level, run, full }: LiveProof, { theme, width, withRun }: PictureOptions): string {
  return withRun && full !== null
    ? renderSvg(level, { run: full, holds: run.holds, width, theme })
    : renderSvg(level, { width, theme });
}

/**
 * The same picture as a PNG.
 * @param scale pixels per px
 * @throws (rejects) if the browser can't draw it
 */
export async function toPng(svg: string, scale = 2): Promise<Blob> {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(image.naturalWidth * scale);
    canvas.height = Math.round(image.naturalHeight * scale);
    const context = canvas.getContext('2d');
    if (context === null) throw new Error('the browser gives no canvas to draw on');
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob(
        (blob) => (blob === null ? reject(new Error('the picture is too large for this browser')) : resolve(blob)),
        'image/png',
      );
    });
  } finally {
    URL.revokeObjectURL(image.src);
  }
}
