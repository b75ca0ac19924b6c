import { mkdirSync, mkdtempSync, readdirSync, readFileSync, readlinkSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { type EditServer, startServer } from '../../cli/serve/index.ts';
import { EDIT_API } from '../../schema/index.ts';

// servers remember their ports, which must not happen in the home of the user who runs the tests
process.env.XDG_STATE_HOME ??= join(tmpdir(), 'gq-test-state');

/** The text of a valid level. */
export const levelText = (name: string, x = 0): string =>
  `${JSON.stringify({ version: 1, name, astronaut: { x, y: 0 }, blackHole: { x: 170, y: 0 } }, null, 2)}\n`;

export interface Answered {
  readonly status: number;
  readonly headers: NodeJS.Dict<string | string[]>;
  readonly text: string;
  /** The text as JSON. */
  readonly json: () => never;
}

/** A request; `path` is sent unchanged. */
export interface Asked {
  readonly method?: string;
  readonly path?: string;
  /** Headers in addition to those of the page; undefined removes one. */
  readonly headers?: Readonly<Record<string, string | string[] | undefined>>;
  readonly body?: string | Uint8Array;
}

/** A page of a server that can also send forged requests. */
export interface Page {
  readonly port: number;
  readonly token: string;
  ask(asked: Asked): Promise<Answered>;
  get(path: string): Promise<Answered>;
  /** Sends JSON; the base of the change goes into `headers`. */
  send(method: string, path: string, body: unknown, headers?: Asked['headers']): Promise<Answered>;
}

export const levelPath = (id: string): string => `${EDIT_API.LEVEL}?id=${encodeURIComponent(id)}`;

export function pageOf(server: Pick<EditServer, 'port' | 'address'>): Page {
  const { port } = server;
  const token = new URL(server.address).hash.slice('#token='.length);
  const ask = ({ method = 'GET', path = '/', headers = {}, body }: Asked): Promise<Answered> =>
    new Promise((resolve, reject) => {
      const host = `127.0.0.1:${port}`;
      const usual = { Host: host, Origin: `http://${host}`, 'Sec-Fetch-Site': 'same-origin', 'Content-Type': 'application/json' };
      const all = { ...usual, [EDIT_API.TOKEN_HEADER]: token, ...headers };
      const kept = Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined)) as Record<string, string>;
      const sent = request({ host: '127.0.0.1', port, method, path, headers: kept, setHost: false, agent: false }, (answer) => {
        const pieces: Buffer[] = [];
        answer.on('data', (piece: Buffer) => pieces.push(piece));
        answer.on('error', reject);
        answer.on('end', () => {
          const text = Buffer.concat(pieces).toString();
          resolve({ status: answer.statusCode ?? 0, headers: answer.headers, text, json: () => JSON.parse(text) as never });
        });
      });
      sent.on('error', reject);
      sent.on('upgrade', () => reject(new Error('the server agreed to an upgrade')));
      sent.end(body);
    });
  return {
    port,
    token,
    ask,
    get: (path) => ask({ path }),
    send: (method, path, body, headers) => ask({ method, path, headers, body: JSON.stringify(body) }),
  };
}

/** Makes a folder. @param files names and contents */
export function makeFolder(files: Readonly<Record<string, string | Uint8Array>>): { folder: string; remove: () => void } {
  const folder = mkdtempSync(join(tmpdir(), 'gq-edit-'));
  for (const [name, content] of Object.entries(files)) put(folder, name, content);
  return { folder, remove: () => rmSync(folder, { recursive: true, force: true }) };
}

export function put(folder: string, name: string, content: string | Uint8Array): void {
  mkdirSync(dirname(join(folder, name)), { recursive: true });
  writeFileSync(join(folder, name), content);
}

/** Everything below a folder: the contents of files, the targets of links. */
export function everythingIn(folder: string): Record<string, string> {
  const found: Record<string, string> = {};
  for (const entry of readdirSync(folder, { recursive: true, withFileTypes: true })) {
    const path = join(entry.parentPath, entry.name);
    const name = path.slice(folder.length + 1);
    if (entry.isFile()) found[name] = readFileSync(path, 'latin1');
    else found[name] = entry.isSymbolicLink() ? `-> ${readlinkSync(path)}` : entry.isDirectory() ? 'folder' : 'other';
  }
  return found;
}

/** A minimal built page. */
export const PAGE_FILES = { 'index.html': '<!doctype html><title>page</title>', 'assets/index-abc.js': 'export {};\n' };

/** Starts a server on a folder, and a page of it. */
export async function serve(folder: string): Promise<EditServer & { page: Page; crashes: readonly unknown[] }> {
  const built = makeFolder(PAGE_FILES);
  const crashes: unknown[] = [];
  const server = await startServer({
    folder,
    port: 0,
    configFrom: folder,
    page: built.folder,
    game: fileURLToPath(new URL('../../dist/site', import.meta.url)),
    onCrash: (error) => crashes.push(error),
  });
  built.remove();
  return { ...server, page: pageOf(server), crashes };
}
