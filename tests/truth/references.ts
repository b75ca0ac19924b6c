import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { importOriginal, type Level, resolveLevel } from '../../schema/index.ts';
import { importedLevels } from './imported-levels.ts';
import { truthFolder } from './recordings.ts';

/** A run in continuous time, computed in quadruple precision by other means than the engine's. */
export interface Reference {
  readonly name: string;
  readonly holds: readonly [number, number][];
  readonly recoil: boolean;
  readonly outcome: 'completed' | 'collided' | 'lost' | 'timeout';
  readonly with: { readonly kind: string; readonly index: number } | null;
  readonly time: number;
  readonly final: { readonly x: number; readonly y: number; readonly vx: number; readonly vy: number; readonly angle: number };
  readonly minerals: readonly { readonly index: number; readonly time: number }[];
  readonly switches: readonly { readonly time: number; readonly from: number; readonly to: number }[];
  readonly events: readonly { readonly time: number; readonly what: string }[];
  readonly explosions: readonly { readonly time: number; readonly aliens: readonly [number, number] }[];
  readonly samples: readonly [t: number, x: number, y: number, vx: number, vy: number][];
  readonly clearance: { readonly distance: number; readonly kind: string; readonly index: number; readonly time: number } | null;
  /** Change of the end per change of the start; likewise of its time and of the samples. */
  readonly sensitivity: number;
  readonly timeSensitivity: number;
  readonly sampleSensitivity: number;
  readonly conditioning?: 'ok' | 'exact' | 'ill';
}

export interface ReferenceCase {
  readonly id: string;
  readonly why: string;
  readonly level: Level;
  readonly reference: Reference;
  /** Small errors grow too much for the end to mean anything: reported, not asserted. */
  readonly ill: boolean;
}

/** More than this, and the last bit of the start decides. */
const ILL = 1e6;

const isIll = (r: Reference) => r.conditioning === 'ill' || (r.conditioning === undefined && r.sensitivity > ILL);

const continuous = join(truthFolder, 'continuous');
const hard = join(truthFolder, 'hard.json');

export const hasContinuousReferences = existsSync(continuous);
export const hasHardReferences = existsSync(hard);

/** What a person is told who has no references. */
export const NO_REFERENCES = 'no references in continuous time at ../shared/truth: name their folder in GQ_TRUTH';

/** The runs of the original's levels. */
export function continuousReferences(): ReferenceCase[] {
  const levels = importedLevels();
  return readdirSync(continuous)
    .filter((file) => file.endsWith('.json.gz'))
    .sort()
    .flatMap((file) => {
      const { level: number, runs } = JSON.parse(gunzipSync(readFileSync(join(continuous, file))).toString('utf8'));
      const level = levels.get(number);
      if (level === undefined) throw new Error(`${file}: level ${number} was not imported`);
      return (runs as Reference[]).map((reference) => ({
        id: `level ${number}, ${reference.name}${reference.recoil ? ', recoil' : ''}`,
        why: 'a run of an original level',
        level: { ...level, recoil: reference.recoil },
        reference,
        ill: isIll(reference),
      }));
    });
}

/** Synthetic cases, each hard in a way of its own. */
export function hardReferences(): ReferenceCase[] {
  const cases: (Reference & { why: string; level: object })[] = JSON.parse(readFileSync(hard, 'utf8'));
  return cases.map(({ why, level, ...reference }) => {
    const imported = importOriginal(JSON.stringify([level]), { recoil: reference.recoil });
    if (!imported.ok) throw new Error(`${reference.name}: ${imported.problems.map((p) => p.message).join('\n')}`);
    return { id: reference.name, why, level: resolveLevel(imported.levels[0].file), reference, ill: isIll(reference) };
  });
}
