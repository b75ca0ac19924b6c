import { createHash } from 'node:crypto';
import { extname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readBuilt } from '../io/index.ts';

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
  for (const [path, content] of readBuilt(folder, "the editor's page")) {
    const type = TYPES[extname(path)];
    if (type === undefined) continue;
    const etag = `"${createHash('sha256').update(content).digest('base64url')}"`;
    files.set(`/${path}`, { content, type, etag, isForever: path.startsWith('assets/') });
  }
  return files.set('/', files.get('/index.html')!);
}
