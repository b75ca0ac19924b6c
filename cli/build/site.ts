import { createHash, randomBytes } from 'node:crypto';
import { lstatSync, mkdirSync, readdirSync, rmdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PACK_FILE, type Pack, packScript, pageOf } from '../../check/pack/index.ts';
import {
  type FileStatus,
  makeFolders,
  type PlannedFile,
  planFile,
  readBuilt,
  readRegularFile,
  removeFolders,
  renamePatiently,
  statOrError,
  writeAll,
} from '../io/index.ts';
import { allOrNone, Failure, namedPath, systemReason, uncut } from '../terminal/index.ts';

/** What becomes of a file of a site. */
export interface SiteFile {
  /** Its path, as the working directory sees it. */
  readonly file: string;
  readonly status: FileStatus | 'removed';
  /** Bytes; 0 if it is removed. */
  readonly bytes: number;
}

/** What `gq build` is going to do in a folder. */
interface SitePlan {
  readonly site: string;
  /** The folder in messages. */
  readonly shown: string;
  /** Whether the folder is made. */
  readonly isNew: boolean;
  readonly files: readonly (PlannedFile & { readonly name: string })[];
  /** The paths of files of an earlier version that this one does not have. */
  readonly stale: readonly string[];
}

/** The largest file of a site: the pack of a large folder, bytes */
const LARGEST = 512 * 1024 * 1024;

/** Entries of a folder that a message names. */
const MOST_NAMED = 3;

/** How messages speak of a folder. */
export interface SiteWords {
  readonly shown: string;
  /** What to do when the folder is not empty, and none of an earlier build. */
  readonly ifTaken: string;
  /** What to do when somebody has changed files of an earlier build. */
  readonly ifChanged: string;
}

const inCommand = (site: string): SiteWords => ({
  shown: `--out ${namedPath(site)}`,
  ifTaken: '--overwrite writes the page beside what is there',
  ifChanged: 'keep a copy of your changes, or give --overwrite to lose them',
});

/**
 * Compares a folder with the files that are to be in it. Nothing is changed yet.
 * @param overwrite whether to write over files that `gq build` has not written, or that have changed since
 * @throws Failure if the folder is not one that may be written
 */
export function planSite(
  site: string,
  files: ReadonlyMap<string, Uint8Array>,
  overwrite: boolean,
  words: SiteWords = inCommand(site),
): SitePlan {
  const { shown } = words;
  if (site === '') throw new Failure(`${shown}: expected a folder, found an empty name`);
  const stats = statOrError(site);
  const plan = (): SitePlan['files'] =>
    [...files].map(([name, content]) => ({ name, ...planFile(join(site, name), content, 'gq build', LARGEST) }));
  if (stats instanceof Error) {
    if ((stats as NodeJS.ErrnoException).code !== 'ENOENT')
      throw new Failure(`${shown}: can't be opened: ${systemReason(stats)}`);
    return { site, shown, isNew: true, files: plan(), stale: [] };
  }
  if (!stats.isDirectory()) throw new Failure(`${shown}: is a file; expected a folder, or a name for a new one`);
  const own = ownFiles(site);
  const entries = namesIn(site, shown);
  if (own === null && entries.length > 0 && !overwrite) throw notOurs(words, entries);
  const planned = plan();
  const isOurs = ({ name, before, status }: (typeof planned)[number]): boolean =>
    status !== 'overwritten' || name === MARKER || own?.get(name) === hashOf(before!);
  const others = planned.filter((file) => !isOurs(file) || isThroughLink(site, file.name));
  if (others.length > 0 && !overwrite) {
    const names = others.map(({ file }) => `  ${file}\n`).join('');
    const what = others.length === 1 ? 'this file is' : 'these files are';
    throw new Failure(
      `nothing was written, because ${what} not as gq build has left ${others.length === 1 ? 'it' : 'them'}:\n${names}expected only files of the last build; ${words.ifChanged}`,
    );
  }
  const stale = [...(own ?? [])].flatMap(([name, hash]) => {
    const path = join(site, name);
    return !files.has(name) && hashNow(path) === hash && !isThroughLink(site, name) ? [path] : [];
  });
  return { site, shown, isNew: false, files: planned, stale };
}

function notOurs({ shown, ifTaken }: SiteWords, entries: readonly string[]): Failure {
  const named = entries.slice(0, MOST_NAMED).join(', ');
  const more = entries.length > MOST_NAMED ? ` and ${entries.length - MOST_NAMED} more` : '';
  return new Failure(
    `${shown}: gq build has not made this folder, and it is not empty (${named}${more}): expected a new or an empty folder, or one of an earlier build; ${ifTaken}`,
  );
}

function namesIn(site: string, shown: string): readonly string[] {
  try {
    return readdirSync(site).sort();
  } catch (error) {
    throw new Failure(`${shown}: can't be read: ${systemReason(error)}`);
  }
}

/** Whether a link lies between a site and a file in it: it may lead out of the folder. */
function isThroughLink(site: string, name: string): boolean {
  const parts = name.split('/');
  return parts.some((_, i) => isLink(join(site, ...parts.slice(0, i + 1))));
}

function isLink(path: string): boolean {
  try {
    return lstatSync(path).isSymbolicLink();
  } catch {
    return false;
  }
}

/** The hashes of the files that an earlier build has written; null if there was none. */
function ownFiles(site: string): ReadonlyMap<string, string> | null {
  try {
    return readMarker(Buffer.from(readRegularFile(join(site, MARKER), LARGEST)).toString());
  } catch {
    return null;
  }
}

function hashNow(path: string): string | null {
  try {
    return hashOf(readRegularFile(path, LARGEST));
  } catch {
    return null;
  }
}

/**
 * Writes a site: all of it or nothing, also when a signal comes. A new folder gets its name when it is complete. In an existing
 * one, each file is replaced, and what `gq build` has not written stays.
 * @throws Failure if it can't be written
 */
export async function writeSite(plan: SitePlan): Promise<readonly SiteFile[]> {
  if (plan.isNew) await writeNew(plan);
  else await writeInto(plan);
  return [
    ...plan.files.map(({ file, status, content }): SiteFile => ({ file, status, bytes: content.length })),
    ...plan.stale.map((file): SiteFile => ({ file, status: 'removed', bytes: 0 })),
  ];
}

async function writeNew({ site, shown, files }: SitePlan): Promise<void> {
  const target = resolve(site);
  const above = dirname(target);
  const unfinished = `${target}.gq-build-${randomBytes(4).toString('hex')}`;
  let made: string | undefined;
  const steps = [
    () => {
      made = makeFolders(above);
      mkdirSync(unfinished);
    },
    ...files.map(({ name, content }) => () => {
      const path = join(unfinished, name);
      makeFolders(dirname(path));
      writeFileSync(path, content, { flag: 'wx' });
    }),
    // fails if somebody has put something there meanwhile
    () => renamePatiently(unfinished, target),
  ];
  const takeBack = (): void => {
    rmSync(unfinished, { recursive: true, force: true });
    if (made !== undefined) removeFolders(above, made);
  };
  try {
    await allOrNone(steps, takeBack);
  } catch (error) {
    throw new Failure(`${shown}: can't be written: ${systemReason(error)}; nothing was written`);
  }
}

async function writeInto({ site, shown, files, stale }: SitePlan): Promise<void> {
  const isFirst = ({ name, before }: (typeof files)[number]): boolean => name === MARKER && before === null;
  // in an empty folder the marker comes first: if the process is killed, the next build knows the folder as its own
  const ordered = [...files.filter(isFirst), ...files.filter((file) => !isFirst(file))];
  await writeAll(ordered, () => shown);
  await uncut(() => {
    for (const path of stale) removeOwn(path, site);
  });
}

/** Removes a file, and its folder inside the site if that is then empty. */
function removeOwn(path: string, site: string): void {
  rmSync(path, { force: true });
  const folder = dirname(path);
  if (resolve(folder) !== resolve(site) && readdirSync(folder).length === 0) rmdirSync(folder);
}

/** The file by which `gq build` knows a folder that it has made, and its own files in it. */
const MARKER = '.gq-build.json';

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
const hashOf = (content: Uint8Array): string =>
  createHash('sha256').update(Buffer.from(content).toString('latin1').replaceAll('\r\n', '\n'), 'latin1').digest('hex');

/** Names that stay in their folder, whoever has written them. */
const INSIDE = /^(?!\.\.?(?:\/|$))[\w.-]+(?:\/(?!\.\.?(?:\/|$))[\w.-]+)*$/;

/** The hashes of the files that a marker lists; null if it is none. */
function readMarker(text: string): ReadonlyMap<string, string> | null {
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

/** The folder into which `npm run build` puts the game. */
export const GAME = fileURLToPath(new URL('../../site', import.meta.url));

/**
 * The files of the built game by their path in it, with slashes, sorted.
 * @throws Failure if there is no built game
 */
export const readGame = (folder: string): ReadonlyMap<string, Uint8Array> =>
  new Map([...readBuilt(folder, 'the game')].sort(([a], [b]) => (a < b ? -1 : 1)));
