import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { extname, join, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Failure, systemReason } from '../failure.ts';

/** A file of the page. */
export interface PageFile {
  readonly content: Uint8Array<ArrayBuffer>;
  readonly type: string;
  readonly etag: string;
  /** Whether the name contains a hash of the content, so that the file never changes. */
  readonly isForever: boolean;
}

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.webmanifest': 'application/manifest+json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ico': 'image/x-icon',
  '.webp': 'image/webp',
  '.woff2': 'font/woff2',
  '.txt': 'text/plain; charset=utf-8',
  '.map': 'application/json',
};

/** The folder into which `npm run build` puts the editor. */
export const PAGE = fileURLToPath(new URL('../../editor', import.meta.url));

/**
 * The files of the built page by address. They are read once: an address is only looked up and never becomes a path, and a
 * later build can't mix two versions.
 * @throws Failure if there is no built page
 */
export function readPage(folder: string): ReadonlyMap<string, PageFile> {
  const files = new Map<string, PageFile>();
  try {
    for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
      const type = TYPES[extname(entry.name)];
      if (!entry.isFile() || type === undefined) continue;
      const path = join(entry.parentPath, entry.name);
      const content = new Uint8Array(readFileSync(path));
      const address = path.slice(folder.length).split(sep).join('/');
      const etag = `"${createHash('sha256').update(content).digest('base64url')}"`;
      files.set(address, { content, type, etag, isForever: address.startsWith('/assets/') });
    }
  } catch (error) {
    throw new Failure(`the editor's page can't be read: ${folder}: ${systemReason(error)}; npm run build makes it again`);
  }
  const index = files.get('/index.html');
  if (index === undefined)
    throw new Failure(`the editor's page is missing: expected ${folder}/index.html; npm run build makes it`);
  return files.set('/', index);
}
