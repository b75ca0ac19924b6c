import { existsSync, type Stats, statSync } from 'node:fs';
import { Failure, systemReason } from './failure.ts';
import { type Standing, whatStands } from './own-report.ts';
import { entryName } from './packs/index.ts';
import { realTarget } from './real-target.ts';

/** The files that a command reads, by what each of them is in words; null: there is none. */
export type Inputs = Readonly<Record<string, string | readonly string[] | null>>;

/**
 * The levels that a command reads, as {@link Inputs}. An entry of a pack stands for its pack.
 * @param done what is done with them, for messages
 */
export const levelsRead = (files: readonly string[], done: 'checked' | 'read'): Inputs => ({
  [`a level that is ${done}`]: files.map(fileOf),
});

function fileOf(level: string): string {
  const entry = existsSync(level) ? null : entryName(level);
  return entry === null ? level : entry.pack;
}

/**
 * Decides, for every command, which file its output may replace: none that it reads, by whatever name, and no level.
 */
export class Outputs {
  private readonly read: ReadonlyMap<string, string>;
  private names: ReadonlyMap<string, string> | null = null;

  constructor(private readonly inputs: Inputs) {
    this.read = this.inWords((path) => realTarget(path));
  }

  /** What output at a path would replace, in words; null if nothing that must stay. */
  wouldReplace(path: string): string | null {
    const stats = statsOf(path);
    // a device has nothing to lose
    if (stats !== undefined && !stats.isFile()) return null;
    return this.input(path, stats) ?? (stats !== undefined && standing(path) === 'level' ? 'a level' : null);
  }

  /** The same for output that is levels: only what the command reads must stay. */
  wouldReplaceInput(path: string): string | null {
    return this.input(path, statsOf(path));
  }

  private input(path: string, stats: Stats | undefined): string | null {
    return this.read.get(realTarget(path)) ?? (stats === undefined ? null : this.byOtherName(stats));
  }

  /** The input that is the same file by another name, a hard link. */
  private byOtherName(stats: Stats): string | null {
    if (stats.nlink < 2) return null;
    this.names ??= this.inWords((path) => {
      const input = statsOf(path);
      return input === undefined ? '' : idOf(input);
    });
    return this.names.get(idOf(stats)) ?? null;
  }

  private inWords(keyOf: (path: string) => string): Map<string, string> {
    const words = new Map<string, string>();
    for (const [what, paths] of Object.entries(this.inputs)) {
      for (const path of [paths ?? []].flat()) {
        try {
          words.set(keyOf(path), what);
        } catch {
          // what can't be reached can't be replaced
        }
      }
    }
    return words;
  }
}

/** undefined: there is nothing, and perhaps there can't be, since a part of the path is a file; writing says so. */
function statsOf(path: string): Stats | undefined {
  try {
    return statSync(path, { throwIfNoEntry: false });
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOTDIR') return undefined;
    throw error;
  }
}

const idOf = ({ dev, ino }: Stats): string => `${dev} ${ino}`;

/** What is at a path; a file that can't be read is none of ours. */
export function standing(path: string): Standing {
  try {
    return whatStands(path);
  } catch {
    return 'other';
  }
}

/**
 * Checks before the work that output may be written to a path.
 * @param given the option and its value, for the message
 * @throws Failure if it would replace what must stay
 */
export function expectOutput(given: string, path: string, inputs: Inputs): void {
  let what: string | null;
  try {
    what = new Outputs(inputs).wouldReplace(path);
  } catch (error) {
    throw new Failure(`${path}: can't be written: ${systemReason(error)}`);
  }
  if (what !== null) throw new Failure(`nothing was done: ${given}: it would replace ${what}; give it another file`);
}
