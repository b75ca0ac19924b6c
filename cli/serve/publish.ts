import { lstatSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { LEVEL_ID_PART, type PublishRequest, type PublishResponse, type RefusedLevel } from '../../schema/index.ts';
import {
  type BuiltPack,
  checkPack,
  findPack,
  isUnplayable,
  packOf,
  planSite,
  readGame,
  refusedOf,
  type SiteWords,
  siteFiles,
  whyRefused,
  writeSite,
} from '../build/index.ts';
import { type ConfigOptions, readConfiguration } from '../config/index.ts';
import { FileFailure } from '../report-parts/index.ts';
import { Failure } from '../terminal/index.ts';
import { findLevel } from './level-files.ts';
import { Refusal, unknownLevel } from './refusal.ts';

export interface PublishOptions {
  /** The folder's real path. */
  readonly root: string;
  /** The folder as the user named it. */
  readonly shown: string;
  /** The search for `gq.config.json` starts in this folder and goes upwards. */
  readonly configFrom: string;
  /** A file to read instead, or false for none. */
  readonly config?: ConfigOptions['config'];
  /** The folder that contains the built game. */
  readonly game: string;
}

/** Makes a page of levels. @throws Refusal; nothing is written then */
export type Publish = (request: PublishRequest) => Promise<PublishResponse>;

/**
 * Publishes levels of a folder into another one beside it. The name of that folder is one name and no path; a folder that is there
 * is written to only if it is empty or of an earlier build, and never through a link.
 */
export function createPublish(options: PublishOptions): Publish {
  let last: Promise<unknown> = Promise.resolve();
  // one after the other: two must not write into one folder
  return (request) => {
    const next = last.then(() => publish(options, request));
    last = next.catch(() => {});
    return next;
  };
}

async function publish(
  { root, shown, configFrom, config, game }: PublishOptions,
  request: PublishRequest,
): Promise<PublishResponse> {
  const { site: name, level, title, withRuns, force } = request;
  const site = siteOf(root, name);
  // beside a link to the folder there is nothing
  const near = resolve(shown) === root ? join(shown, '..', name) : site;
  const words: SiteWords = { shown: near, ifTaken: 'choose another name', ifChanged: 'choose another name' };
  try {
    planSite(site, new Map(), false, words);
    const configuration = await readConfiguration({ config }, configFrom);
    const found = level === null ? await findPack([shown], configuration) : null;
    const files = found?.files ?? [fileOf(root, shown, level ?? '')];
    const pack = await checkPack(files, configuration, {
      // under the terms of the folder; slack is not asked for, which would take long
      asked: { seed: 0, requireSlack: false },
      cache: configuration.cache,
      // few threads: the page that asks is on the same machine
      jobs: 2,
      onProgress: () => {},
    });
    refuseLevels(pack, force);
    const chapters = found?.order?.chapters ?? new Map<string, string>();
    const content = siteFiles(readGame(game), packOf(pack, { title, rules: configuration.rules, withRuns, chapters }));
    const written = await writeSite(planSite(site, content, false, words));
    return { site: words.shown, levels: pack.levels.length, bytes: written.reduce((sum, { bytes }) => sum + bytes, 0) };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    throw refusalOfFailure(error);
  }
}

/** What keeps the page from being written, without the lines of files that a terminal shows. */
function refusalOfFailure(error: Failure): Refusal {
  const hint = 'Correct that, then publish again.';
  if (!(error instanceof FileFailure)) return new Refusal('not-published', error.message, hint);
  const files = error.files.map(({ file, problems }) => ({
    file,
    problems: problems.map(({ frame: _, key: __, ...one }) => one),
  }));
  return new Refusal('not-published', error.reason, hint, { files });
}

function siteOf(root: string, name: string): string {
  const hint = 'Use at most 80 letters a-z, digits, spaces, _ and -, and begin with a letter or digit.';
  if (!LEVEL_ID_PART.test(name))
    throw new Refusal('bad-name', `${JSON.stringify(name)} is not a name that a folder can have on every system`, hint);
  if (name.toLowerCase() === basename(root).toLowerCase())
    throw new Refusal('bad-name', `${name} is the folder of the levels`, 'Choose another name for the page.');
  const site = join(dirname(root), name);
  if (lstatSync(site, { throwIfNoEntry: false })?.isSymbolicLink() === true)
    throw new Refusal('not-published', `${name} is a link, which the editor doesn't follow`, 'Choose another name.');
  return site;
}

function fileOf(root: string, shown: string, id: string): { file: string; id: string } {
  const found = findLevel(root, id);
  if (found === undefined || found.isLink) throw unknownLevel(id, `in ${shown}`);
  return { file: join(shown, `${id}.level.json`), id };
}

function refuseLevels(pack: BuiltPack, force: boolean): void {
  const refused = refusedOf(pack, force);
  if (refused.length === 0) return;
  const list = refused.map((level): RefusedLevel => {
    const { id, name, verdict, problems } = level;
    const error = problems.find(({ severity }) => severity === 'error');
    return { id, name, verdict, message: error?.message ?? whyRefused(level) };
  });
  const message = `${refused.length} of ${pack.levels.length} levels can't be published as they are`;
  const hint = refused.some(isUnplayable) ? 'Fix the levels that are not valid.' : 'Fix them, or publish them all the same.';
  throw new Refusal('not-completable', message, hint, { levels: list });
}
