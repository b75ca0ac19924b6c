import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, extname, join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { walk } from '../io/index.ts';

/** A text that is the same for equal plain data, whatever the order of its keys, and different for different data. */
function canonical(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(canonical).join(',')}]`;
  if (typeof value === 'object' && value !== null) {
    const fields = Object.entries(value)
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([key, field]) => `${JSON.stringify(key)}:${canonical(field)}`);
    return `{${fields.join(',')}}`;
  }
  switch (typeof value) {
    case 'string':
      return JSON.stringify(value);
    case 'number':
      // JSON has one text for several numbers: null, and 0
      return Object.is(value, -0) ? '-0' : String(value);
    case 'boolean':
    case 'undefined':
    case 'object':
      return String(value);
    default:
      throw new TypeError(`expected plain data, found a ${typeof value}`);
  }
}

/** A key for plain data, 64 digits in base 16. */
export const keyOf = (data: unknown): string => createHash('sha256').update(canonical(data)).digest('hex');

/** A key for the bytes of a file under a key of everything else that the result depends on. */
export const contentKey = (key: string, bytes: Uint8Array): string =>
  createHash('sha256').update(key).update(bytes).digest('hex');

/** The rooms that decide what a command reports. */
export const DECIDING_ROOMS = ['schema', 'engine', 'solver', 'check', 'cli'] as const;

/** The packages that decide, each with the package that needs it if it is not this one. */
export const DECIDING_PACKAGES: readonly (readonly [name: string, neededBy?: string])[] = [
  ['zod'],
  ['flatbush'],
  ['flatqueue', 'flatbush'],
];

/** What holds the rooms: `dist`, or the project when its sources are run as they are. */
const HERE = fileURLToPath(new URL('../../', import.meta.url));

/** The folders of the modules that run: the bundle has all rooms in one. */
const RUNNING = basename(fileURLToPath(new URL('..', import.meta.url))) === 'gq' ? ['gq'] : DECIDING_ROOMS;

/** The modules that run: `.js`, or `.ts` of the sources. */
const MODULE = extname(new URL(import.meta.url).pathname);

/**
 * A fingerprint of everything that decides besides files and options: the modules of the rooms, the packages they need, and Node.
 * It is computed from the modules that run, so it is right after every build and in every copy.
 * @param root the folder with the rooms
 * @param extension of a module
 * @throws if something is missing
 */
export function semantics(root: string = HERE, extension: string = MODULE): string {
  return createHash('sha256').update(process.version).update(codeFingerprint(root, extension)).digest('hex');
}

let running: string | null = null;

/**
 * The same without Node: results don't depend on it, only a cache takes no chances. That of the modules that run is computed once.
 * @param root the folder with the rooms
 * @param extension of a module
 * @throws if something is missing
 */
export function codeFingerprint(root: string = HERE, extension: string = MODULE): string {
  if (root !== HERE || extension !== MODULE) return fingerprint(root, extension, DECIDING_ROOMS);
  running ??= fingerprint(HERE, MODULE, RUNNING);
  return running;
}

function fingerprint(root: string, extension: string, rooms: readonly string[]): string {
  const hash = createHash('sha256');
  const addFile = (name: string, bytes: Uint8Array): void => {
    // with the length, so that no bytes can look like the beginning of another file
    hash.update(`\0${name}\0${bytes.length}\0`).update(bytes);
  };
  for (const room of rooms) {
    const passes = (below: string): boolean => isModule(below, extension);
    const { files, unreadable } = walk(join(root, room), { links: 'listed', hidden: 'entered', passes });
    for (const { error } of unreadable) throw error;
    const names = files.map(({ below }) => `${room}/${below}`).sort();
    for (const name of names) addFile(name, readFileSync(join(root, name)));
  }
  for (const [name, neededBy] of DECIDING_PACKAGES) {
    const ours = createRequire(import.meta.url);
    const { resolve } = neededBy === undefined ? ours : createRequire(ours.resolve(neededBy));
    hash.update(`\0${name}\0${versionOf(resolve(name), name)}`);
  }
  return hash.digest('hex');
}

const isModule = (name: string, extension: string): boolean => name.endsWith(extension) && !name.endsWith('.d.ts');

/** The version of an installed package, from the nearest manifest of its name. */
function versionOf(main: string, name: string): string {
  for (let at = join(main, '..'); at !== join(at, '..'); at = join(at, '..')) {
    try {
      const manifest = JSON.parse(readFileSync(join(at, 'package.json'), 'utf8')) as { name?: unknown; version?: unknown };
      if (manifest.name === name) return String(manifest.version);
    } catch {
      // there is none here
    }
  }
  throw new Error(`the package ${name} has no manifest`);
}
