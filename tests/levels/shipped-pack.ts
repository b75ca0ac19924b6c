import { readdirSync, readFileSync } from 'node:fs';
import { ACCURACIES, type AccuracyName, compile, type Run, simulate } from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, readLevel } from '../../schema/index.ts';

export interface ShippedLevel {
  /** `NN-slug` */
  readonly slug: string;
  readonly text: string;
  readonly file: LevelFile;
  readonly level: Level;
}

const folder = new URL('../../levels/', import.meta.url);

/** Every shipped level, in order of play. */
export const pack: readonly ShippedLevel[] = readdirSync(folder)
  .filter((name) => name.endsWith('.level.json'))
  .sort()
  .map((name) => {
    const text = readFileSync(new URL(name, folder), 'utf8');
    const reading = readLevel(text);
    if (!reading.ok) throw new Error(`${name}: ${reading.problems.map((p) => p.message).join('; ')}`);
    return { slug: name.replace('.level.json', ''), text, file: reading.document.file, level: reading.level };
  });

/** The shipped level with this end of the slug. */
export function shipped(slug: string): ShippedLevel {
  const found = pack.find((entry) => entry.slug.slice(3) === slug);
  if (found === undefined) throw new Error(`expected a shipped level "${slug}", found ${pack.map((e) => e.slug).join(', ')}`);
  return found;
}

/** The holds of the run with this name. */
export function holdsOf(level: Level, run: string): readonly Hold[] {
  const found = level.runs.find((r) => r.name === run);
  if (found === undefined) throw new Error(`expected a run "${run}" in ${level.name}`);
  return found.holds;
}

export const accuracyNames = Object.keys(ACCURACIES) as AccuracyName[];

/** Simulates the run with this name. */
export const play = (level: Level, run: string, accuracy: AccuracyName): Run =>
  simulate(compile(level, accuracy), holdsOf(level, run));

/** Whether a run keeps the promise of its name: it completes the level, and collects every mineral if the name says so. */
export function keepsPromise(level: Level, runName: string, run: Run): boolean {
  if (run.outcome !== 'completed') return false;
  return runName !== 'all-minerals' || new Set(run.minerals.map((m) => m.index)).size === level.minerals.length;
}
