import type { Outcome, Touched } from '../../engine/index.ts';
import { KINDS, nameWhenTouched } from '../../schema/index.ts';

/** How a run ended. */
export interface RunEnd {
  readonly outcome: Outcome;
  readonly with: Touched | null;
  /** s from the start */
  readonly time: number;
  /** the tick of 1/60 s in which it ended */
  readonly tick: number;
}

/** `nova 3`, counted from 1 as people do; `the black hole`. */
export const touchedInWords = ({ kind, index }: Touched): string =>
  KINDS[kind].list === null ? `the ${KINDS[kind].one}` : `${nameWhenTouched(kind)} ${index + 1}`;

/** How a run ended, for a person: `collides with nova 3 at 3.22 s`. @param range of the level, px */
export function outcomeInWords({ outcome, with: touched, time }: RunEnd, range: number): string {
  const when = `at ${time.toFixed(2)} s`;
  switch (outcome) {
    case 'completed':
      return `reaches the black hole ${when}`;
    case 'collided':
      return `collides with ${touched === null ? 'something' : touchedInWords(touched)} ${when}`;
    case 'lost':
      return `is lost ${when}, farther than ${range} px from every asteroid`;
    case 'timeout':
      return `goes on without an end for ${time} s`;
  }
}

/** Why a run failed, in a few words for the place where it did: `hits nova 3`; null: it did not. */
export function reasonInWords({ outcome, with: touched, time }: RunEnd, range: number): string | null {
  switch (outcome) {
    case 'completed':
      return null;
    case 'collided':
      return `hits ${touched === null ? 'something' : touchedInWords(touched)}`;
    case 'lost':
      return `lost: farther than ${range} px from every asteroid`;
    case 'timeout':
      return `still under way after ${time} s`;
  }
}
