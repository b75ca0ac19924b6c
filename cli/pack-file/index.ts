import { chaptersOf, effectsToMeet, inPackOrder, type MetLevel, packProblems } from '../../check/pack/index.ts';
import { applyPolicy } from '../../check/policy/index.ts';
import {
  levelsOfPack,
  MAX_FILE_SIZE,
  type OwnRules,
  type PackReading,
  readLevel,
  readPack,
  type SeverityMap,
} from '../../schema/index.ts';
import { type FoundPack, levelIdOf, NotAFile, readRegularFile, sortedByPlay } from '../io/index.ts';
import { type ShownProblem, showProblems } from '../report-parts/index.ts';
import { systemReason } from '../terminal/index.ts';

/** What was found about a pack file. */
export interface CheckedPack {
  readonly file: string;
  /** Its name; null if it is not valid. */
  readonly name: string | null;
  /** The ids that it lists, each once, in its order; null if it is not valid. */
  readonly listed: readonly string[] | null;
  readonly problems: readonly ShownProblem[];
  /** The chapter of each level that stands below a heading, by its id. */
  readonly chapters: ReadonlyMap<string, string>;
  /** Whether the file itself could not be read. */
  readonly unreadable: boolean;
}

/** On what the problems of a pack depend besides its folder. */
export interface PackSettings {
  /** The rules of the folder, which decide with the level what it calls for. */
  readonly rules: OwnRules;
  readonly severity: SeverityMap;
}

const NOTHING = { name: null, listed: null, chapters: new Map<string, string>() } as const;

/**
 * Checks a pack file against the levels of its folder. The levels are read, and none is simulated.
 * @param kept the level files that the configuration does not leave out
 */
export function checkPackFile(
  { file, folder, levels }: FoundPack,
  kept: ReadonlySet<string>,
  { rules, severity }: PackSettings,
): CheckedPack {
  const read = readPackFile(file);
  if ('unreadable' in read) {
    const { unreadable: message } = read;
    const problem = {
      code: 'unreadable-file',
      severity: 'error',
      message,
      hint: 'Make the file readable, or remove it.',
    } as const;
    const problems = [{ ...problem, pointer: '', line: null, column: null, frame: null }];
    return { file, ...NOTHING, problems, unreadable: true };
  }
  const { reading } = read;
  if (!reading.ok) {
    return { file, ...NOTHING, problems: showProblems(reading.problems, reading.text), unreadable: false };
  }
  const listed = levelsOfPack(reading.pack);
  const isListed = new Set(listed);
  const met = levels.flatMap((level): MetLevel[] => {
    const id = levelIdOf(folder, level);
    // what the configuration leaves out is there, and nobody misses it in the list
    if (!isListed.has(id)) return kept.has(level) ? [{ id, effects: [] }] : [];
    return [{ id, effects: effectsOfFile(level, rules) }];
  });
  const { problems } = applyPolicy(packProblems(reading, met), { severity, allow: {} });
  const { name } = reading.pack;
  const chapters = chaptersOf(reading.pack);
  return { file, name, listed, chapters, problems: showProblems(problems, reading.text), unreadable: false };
}

/** What players meet in a level file; null if it is no level. */
function effectsOfFile(file: string, rules: OwnRules): readonly string[] | null {
  try {
    const reading = readLevel(readRegularFile(file, MAX_FILE_SIZE), { rules });
    return reading.ok ? effectsToMeet(reading.level) : null;
  } catch {
    // the check of the level says why
    return null;
  }
}

/**
 * The level files of a folder in the order of its pack: those that it lists first, the others after them by name, with numbers by
 * their value. A pack that is not valid says nothing.
 */
export function orderFiles(files: readonly string[], folder: string, packFile: string): string[] {
  const read = readPackFile(packFile);
  if ('unreadable' in read || !read.reading.ok) return [...files];
  const idOf = (file: string): string => levelIdOf(folder, file);
  return inPackOrder(sortedByPlay(files, idOf), idOf, levelsOfPack(read.reading.pack));
}

/** A pack file that was read, or why it could not be read. */
export type PackOnDisk = { readonly reading: PackReading } | { readonly unreadable: string };

export function readPackFile(file: string): PackOnDisk {
  try {
    return { reading: readPack(readRegularFile(file, MAX_FILE_SIZE)) };
  } catch (error) {
    return { unreadable: `can't be read: ${error instanceof NotAFile ? error.message : systemReason(error)}` };
  }
}
