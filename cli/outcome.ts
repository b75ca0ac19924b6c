import type { BodyKind, Run } from '../engine/index.ts';
import { KINDS, type Level, nameWhenTouched } from '../schema/index.ts';

/** `nova 2`, `the black hole`. */
export const bodyInWords = (kind: BodyKind, index: number): string =>
  KINDS[kind].list === null ? `the ${KINDS[kind].one}` : `${nameWhenTouched(kind)} ${index}`;

/** How a run ended, for a person: `collided with nova 2 at 3.217 s (tick 193)`. */
export function outcomeInWords(run: Pick<Run, 'outcome' | 'with' | 'time' | 'tick'>, level: Pick<Level, 'range'>): string {
  const when = `at ${run.time.toFixed(3)} s (tick ${run.tick})`;
  switch (run.outcome) {
    case 'completed':
      return `completed ${when}`;
    case 'collided':
      return `collided with ${run.with === null ? 'something' : bodyInWords(run.with.kind, run.with.index)} ${when}`;
    case 'lost':
      return `lost ${when}: farther than ${level.range} px from every asteroid`;
    case 'timeout':
      return `nothing ended it within ${Number(run.time.toFixed(3))} s`;
  }
}

/** How many different minerals a run collected; `arcade` may count one twice. */
export const collected = (run: Pick<Run, 'minerals'>): number => new Set(run.minerals.map((m) => m.index)).size;
