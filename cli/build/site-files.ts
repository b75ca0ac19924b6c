import { createHash } from 'node:crypto';
import { PACK_FILE, type Pack, packScript, pageOf } from '../../check/pack/index.ts';

/** The file by which `gq build` knows a folder that it has made, and its own files in it. */
export const MARKER = '.gq-build.json';

/** The files of a page that plays a pack, by their path in its folder, with slashes. The same input gives the same bytes. */
export function siteFiles(game: ReadonlyMap<string, Uint8Array>, pack: Pack): ReadonlyMap<string, Uint8Array> {
  const page = new TextDecoder().decode(game.get('index.html'));
  const files = new Map(game);
  files.set('index.html', Buffer.from(pageOf(page, pack.title)));
  files.set(PACK_FILE, Buffer.from(packScript(pack)));
  return files.set(MARKER, Buffer.from(markerText(files)));
}

const MADE_BY = 'gq build';

function markerText(files: ReadonlyMap<string, Uint8Array>): string {
  const hashes = Object.fromEntries([...files].map(([name, content]) => [name, hashOf(content)]));
  return `${JSON.stringify({ madeBy: MADE_BY, version: 1, files: hashes }, null, 2)}\n`;
}

/** A hash that stays when git or an upload changes the ends of lines. */
export const hashOf = (content: Uint8Array): string =>
  createHash('sha256').update(Buffer.from(content).toString('latin1').replaceAll('\r\n', '\n'), 'latin1').digest('hex');

/** Names that stay in their folder, whoever has written them. */
const INSIDE = /^(?!\.\.?(?:\/|$))[\w.-]+(?:\/(?!\.\.?(?:\/|$))[\w.-]+)*$/;

/** The hashes of the files that a marker lists; null if it is none. */
export function readMarker(text: string): ReadonlyMap<string, string> | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  const { madeBy, version, files } = (value ?? {}) as { readonly [key: string]: unknown };
  if (madeBy !== MADE_BY || version !== 1 || typeof files !== 'object' || files === null) return null;
  const entries = Object.entries(files);
  const isSound = entries.every(([name, hash]) => INSIDE.test(name) && typeof hash === 'string');
  return isSound ? new Map(entries as [string, string][]) : null;
}
