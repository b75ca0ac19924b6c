import { type PlayerOptions, readLevel } from 'gravity-quest-toolkit/game';

/** The level as the toolkit reads it, with every default filled in. */
export type Level = Extract<ReturnType<typeof readLevel>, { ok: true }>['level'];

/** A level of the pack, or why it can't be played. */
export type Entry = PlayableEntry | BrokenEntry;

export interface PlayableEntry {
  readonly id: string;
  /** The heading that it stands below; null: none. */
  readonly chapter: string | null;
  /** Its place in the pack, from 1. */
  readonly number: number;
  readonly level: Level;
}

export interface BrokenEntry {
  readonly id: string;
  readonly chapter: string | null;
  readonly number: number;
  /** The file, as far as the pack tells. */
  readonly file: string;
  readonly problem: string;
}

/** What levels are played under, so that they play as they were checked. */
export interface Terms {
  readonly accuracy: Accuracy;
  /** The longest that a play may last, s. */
  readonly maxTime: number;
}

/** What holds where neither pack nor link says anything. */
export const USUAL_TERMS: Terms = { accuracy: 'precise', maxTime: 60 };

/** s; one hour, the longest play that there is */
const LONGEST = 3600;

/** The name of an accuracy. */
export type Accuracy = Extract<PlayerOptions['accuracy'], string>;
const ACCURACIES: readonly Accuracy[] = ['arcade', 'fast', 'standard', 'precise'];

export interface PackReading {
  readonly title: string;
  readonly terms: Terms;
  readonly entries: readonly Entry[];
  /** What is wrong with the pack as a whole; null if it can be played. */
  readonly problem: string | null;
}

export const isPlayable = (entry: Entry): entry is PlayableEntry => 'level' in entry;

const isRecord = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const kindOf = (value: unknown): string => (value === null ? 'null' : Array.isArray(value) ? 'an array' : typeof value);

/** Reads the text of a level file. */
export function readLevelText(text: string): { level: Level } | { problem: string } {
  const reading = readLevel(text);
  if (reading.ok) return { level: reading.level };
  return { problem: reading.pointer ? `${reading.message} (at ${reading.pointer})` : reading.message };
}

function readEntry(found: unknown, number: number, taken: ReadonlySet<string>): Entry {
  const given = isRecord(found) && typeof found.id === 'string' && found.id !== '' ? found.id : null;
  const id = given ?? `level-${number}`;
  const chapter = isRecord(found) && typeof found.chapter === 'string' ? found.chapter : null;
  const broken = (problem: string): BrokenEntry => ({ id, chapter, number, file: `${id}.level.json`, problem });
  if (!isRecord(found)) return broken(`expected { id, level }, found ${kindOf(found)}`);
  if (given === null) return broken(`expected a text as "id", found ${kindOf(found.id)}`);
  if (taken.has(id)) return broken(`the id “${id}” is taken by an earlier level of the pack`);
  if (!isRecord(found.level)) return broken(`expected the content of a level file as "level", found ${kindOf(found.level)}`);
  const reading = readLevelText(JSON.stringify(found.level));
  return 'level' in reading ? { id, chapter, number, level: reading.level } : broken(reading.problem);
}

/** Reads terms. @returns them, or what is wrong with them */
export function termsOf(accuracy: unknown, maxTime: unknown): Terms | { problem: string } {
  if (!ACCURACIES.includes(accuracy as Accuracy))
    return { problem: `expected one of ${ACCURACIES.join(', ')} as "accuracy", found ${JSON.stringify(accuracy)}` };
  if (typeof maxTime !== 'number' || !(maxTime > 0) || maxTime > LONGEST)
    return { problem: `expected seconds, more than 0 and at most ${LONGEST}, as "maxTime", found ${JSON.stringify(maxTime)}` };
  return { accuracy: accuracy as Accuracy, maxTime };
}

/**
 * Reads the pack that pack.js has set. A level that can't be read leaves the others playable.
 * @param found `globalThis.GRAVITY_QUEST_PACK`
 */
export function readPack(found: unknown): PackReading {
  const refused = (problem: string): PackReading => ({ title: 'Gravity Quest', terms: USUAL_TERMS, entries: [], problem });
  if (found === undefined) return refused('pack.js was not loaded: it must be beside this page and set GRAVITY_QUEST_PACK.');
  if (!isRecord(found) || !Array.isArray(found.levels)) {
    return refused('pack.js is damaged: expected GRAVITY_QUEST_PACK = { title, levels: [{ id, level }] }.');
  }
  const title = typeof found.title === 'string' && found.title.trim() !== '' ? found.title.trim() : 'Gravity Quest';
  const taken = new Set<string>();
  const entries = found.levels.map((one, i) => {
    const entry = readEntry(one, i + 1, taken);
    taken.add(entry.id);
    return entry;
  });
  const { accuracy = USUAL_TERMS.accuracy, maxTime = USUAL_TERMS.maxTime } = found;
  const terms = termsOf(accuracy, maxTime);
  if ('problem' in terms) return refused(`pack.js is damaged: ${terms.problem}.`);
  const problem = entries.length === 0 ? 'The pack has no levels: expected at least one in pack.js.' : null;
  return { title, terms, entries, problem };
}
