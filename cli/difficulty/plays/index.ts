import { createReadStream } from 'node:fs';
import process from 'node:process';
import type { Attempt, PlayedBy, RefusedPlay } from '../../../check/plays/index.ts';
import type { Terms } from '../../../engine/index.ts';
import { levelHash, type PlayVerdict } from '../../../game/index.ts';
import { readLevel } from '../../../schema/index.ts';
import type { Goal } from '../../../solver/index.ts';
import { nothingFound, whyMissing } from '../../find/index.ts';
import { filesBelow, onceBy, readBytes, runInPool, STDIN, STDIN_NAME, sortedByPlay, statOrError } from '../../io/index.ts';
import { Failure, namedPath, systemReason } from '../../terminal/index.ts';
import { linesOf } from '../../verify/index.ts';
import type { PlayedLevel, PlayFinding, PlaySource, PlayTask } from './read-plays.ts';

/** Plays that are sent to a worker together. */
const TOGETHER = 250;

/** Plays whose files or lines are kept in memory at a time. */
const AT_A_TIME = 20_000;

/** The plays of one level. */
export interface LevelPlays {
  /** What they turned out to be; their indices count from 0 here. */
  readonly replayed: readonly (Attempt | RefusedPlay)[];
  /** Who made each; null if nobody knows. */
  readonly by: readonly (PlayedBy | null)[];
  /** What to call each: its file, or file and line. */
  readonly names: readonly string[];
}

/** A play of which nobody knows which level it is of, and why it does not count. */
interface UnusablePlay {
  readonly name: string;
  readonly verdict: Exclude<PlayVerdict, 'ok'>;
  readonly message: string;
}

/** All plays that were found. */
export interface CollectedPlays {
  /** How many there are. */
  readonly found: number;
  /** Those of each level file. */
  readonly levels: ReadonlyMap<string, LevelPlays>;
  /** Those that can't be read. */
  readonly refused: readonly UnusablePlay[];
  /** How many are of other levels, or other versions, by the hash of the level; the most frequent first. */
  readonly elsewhere: readonly { readonly hash: string; readonly count: number }[];
  /** How many files beside them are no plays. */
  readonly ignored: number;
  /** Files and directories that could not be read. */
  readonly unreadable: readonly { readonly path: string; readonly reason: string }[];
}

interface Named {
  readonly source: PlaySource;
  readonly name: string;
  readonly player: string | null;
}

/**
 * Reads plays and simulates each once, in worker threads.
 * @param paths files and directories with plays
 * @param levelFiles the level files that plays may be of
 * @param settings under which terms the levels are read, and what an attempt has to achieve
 * @param jobs the largest number of threads
 * @param onProgress called now and then with the number of plays that are done
 * @throws Failure if there is no play
 */
export async function collectPlays(
  paths: readonly string[],
  levelFiles: readonly string[],
  settings: { readonly terms: Terms; readonly goal: Goal },
  jobs: number,
  onProgress: (done: number) => void,
): Promise<CollectedPlays> {
  const { files, ignored, unreadable } = findPlays(paths);
  const collection = new Collection(playedLevels(levelFiles, settings.terms), [...unreadable]);
  for await (const named of inPortions(files, collection)) {
    const tasks: PlayTask[] = [];
    for (let i = 0; i < named.length; i += TOGETHER) {
      const sources = named.slice(i, i + TOGETHER).map(({ source }) => source);
      tasks.push({ sources, levels: collection.known, terms: settings.terms, goal: settings.goal });
    }
    const before = collection.found;
    const findings = await runInPool<PlayTask, PlayFinding[]>(new URL('./worker.js', import.meta.url), tasks, jobs, (done) =>
      onProgress(before + Math.min(done * TOGETHER, named.length)),
    );
    for (const [i, finding] of findings.flat().entries()) collection.add(named[i], finding);
  }
  if (collection.found === 0 && collection.unreadable.length === 0) {
    throw new Failure(`nothing was done: ${paths.map(namedPath).join(', ')}: no line is a play`);
  }
  return { ...collection.result(), ignored };
}

/** The levels that plays may be of. Files that are not valid levels are reported where they are measured. */
function playedLevels(files: readonly string[], terms: Terms): PlayedLevel[] {
  return files.flatMap((file): PlayedLevel[] => {
    try {
      const read = readLevel(readBytes(file), terms);
      return read.ok ? [{ hash: levelHash(read.level), file }] : [];
    } catch (error) {
      if (error instanceof Failure) return [];
      throw error;
    }
  });
}

/** Every play, in portions that fit into memory. */
async function* inPortions(files: readonly PlayFile[], collection: Collection): AsyncGenerator<Named[]> {
  let portion: Named[] = [];
  for (const { path, hasLines, player } of files) {
    if (!hasLines) portion.push({ source: { path }, name: path, player });
    else {
      try {
        for await (const lines of linesOf(path === STDIN ? process.stdin : createReadStream(path))) {
          for (const { number, text } of lines)
            portion.push({ source: { line: text }, name: `${path === STDIN ? STDIN_NAME : path}:${number}`, player });
          if (portion.length >= AT_A_TIME) {
            yield portion;
            portion = [];
          }
        }
      } catch (error) {
        collection.unreadable.push({ path, reason: systemReason(error) });
      }
    }
    if (portion.length >= AT_A_TIME) {
      yield portion;
      portion = [];
    }
  }
  if (portion.length > 0) yield portion;
}

class Collection {
  found = 0;
  private readonly levels = new Map<string, { replayed: (Attempt | RefusedPlay)[]; by: (PlayedBy | null)[]; names: string[] }>();
  private readonly refused: UnusablePlay[] = [];
  private readonly elsewhere = new Map<string, number>();

  constructor(
    readonly known: readonly PlayedLevel[],
    readonly unreadable: { path: string; reason: string }[],
  ) {
    for (const { hash } of known) this.levels.set(hash, { replayed: [], by: [], names: [] });
  }

  add({ name: place, player: folder }: Named, finding: PlayFinding): void {
    if (finding.kind === 'empty') return;
    const name = finding.id === null ? place : `${place} (${finding.id})`;
    if (finding.kind === 'unreadable') {
      this.unreadable.push({ path: name, reason: finding.message });
      return;
    }
    const order = this.found++;
    if (finding.kind === 'elsewhere') this.elsewhere.set(finding.hash, (this.elsewhere.get(finding.hash) ?? 0) + 1);
    else if (finding.kind === 'refused') this.refused.push({ name, verdict: finding.verdict, message: finding.message });
    else {
      const own = this.levels.get(finding.hash);
      if (own === undefined) throw new Error('a play of a level that was not asked for');
      const player = finding.subject ?? folder;
      own.replayed.push({ ...finding.replayed, play: own.replayed.length });
      own.by.push(player === null ? null : { player, order });
      own.names.push(name);
    }
  }

  result(): Omit<CollectedPlays, 'ignored'> {
    const elsewhere = [...this.elsewhere].map(([hash, count]) => ({ hash, count }));
    return {
      found: this.found,
      levels: new Map(this.known.flatMap(({ hash, file }) => [[file, this.levels.get(hash) as LevelPlays] as const])),
      refused: this.refused,
      elsewhere: elsewhere.sort((a, b) => b.count - a.count || (a.hash < b.hash ? -1 : 1)),
      unreadable: this.unreadable,
    };
  }
}

/** A file with plays. */
interface PlayFile {
  readonly path: string;
  /** Whether each of its lines is a play; else the file is one play. */
  readonly hasLines: boolean;
  /** Who played: the folder below the one that was given; null if the file is not in such a folder. */
  readonly player: string | null;
}

/** The files with plays that paths name. */
interface FoundPlays {
  /** In the order of the paths; the files of a directory in natural order, `2.gqr` before `10.gqr`. */
  readonly files: readonly PlayFile[];
  /** How many other files are in the directories. */
  readonly ignored: number;
  /** Directories that could not be read. */
  readonly unreadable: readonly { readonly path: string; readonly reason: string }[];
}

const PLAY = /\.gqr$/i;
const LINES = /\.(?:ndjson|jsonl)$/i;

/**
 * Finds plays. A directory stands for every play below it, except in hidden directories and node_modules. A file that is named
 * counts whatever its name: as a play if it ends in `.gqr`, else as lines.
 * @throws Failure with every path that has no play
 */
function findPlays(paths: readonly string[]): FoundPlays {
  const files: PlayFile[] = [];
  const unreadable: { path: string; reason: string }[] = [];
  const unmatched: string[] = [];
  let ignored = 0;
  for (const path of paths) {
    if (path === STDIN && process.stdin.isTTY) {
      throw new Failure('standard input is a terminal: expected plays from a file or a pipe, as in --plays - < plays.ndjson');
    }
    const stats = path === STDIN ? null : statOrError(path);
    if (stats instanceof Error) {
      unmatched.push(`${namedPath(path)}: ${whyMissing(path, stats)}`);
    } else if (stats === null || !stats.isDirectory()) {
      files.push({ path, hasLines: !PLAY.test(path), player: null });
    } else {
      const before = unreadable.length;
      const all = filesBelow(path, () => true, unreadable);
      const plays = all.filter((file) => PLAY.test(file) || LINES.test(file));
      const others = all.length - plays.length;
      ignored += others;
      if (plays.length === 0 && unreadable.length === before) {
        const beside = others === 0 ? '' : `, only ${others} other file${others === 1 ? '' : 's'}`;
        unmatched.push(`${namedPath(path)}: the directory contains no *.gqr, *.ndjson or *.jsonl${beside}`);
      }
      const own = plays.map((file) => ({ path: file, hasLines: LINES.test(file), player: folderBelow(path, file) }));
      files.push(...sortedByPlay(own, (file) => file.path));
    }
  }
  if (unmatched.length > 0) {
    const what = unmatched.length === 1 ? 'a path of --plays has no plays' : 'paths of --plays have no plays';
    throw nothingFound(`nothing was done: ${what}`, unmatched, 'expected plays (.gqr), NDJSON, or directories of them');
  }
  return { files: onceBy(files, ({ path }) => path), ignored, unreadable };
}

/** The folder of a file, from the directory in which it was found; null if that is the directory itself. */
function folderBelow(directory: string, file: string): string | null {
  const path = directory === '.' ? file : file.slice(directory.endsWith('/') ? directory.length : directory.length + 1);
  const end = path.lastIndexOf('/');
  return end < 0 ? null : path.slice(0, end);
}
