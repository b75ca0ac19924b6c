import { createStore } from 'zustand/vanilla';
import { plural } from '../../../check/words/index.ts';
import { ofDocument } from '../../core/kept/index.ts';

/** How many of the level's runs that were completed before a change are completed after it. */
export interface Surviving {
  readonly complete: number;
  readonly of: number;
}

/** What was done to keep the shown run alive. */
export type AliveState =
  /** Nothing had to be done. */
  | { readonly kind: 'idle' }
  /** The level is broken, and other times are sought. */
  | { readonly kind: 'working' }
  | {
      readonly kind: 'alive';
      readonly run: string;
      /** How many presses and releases are shifted, and the largest shift, ticks. */
      readonly edges: number;
      readonly most: number;
      /** How many minerals are not collected any more. */
      readonly lost: number;
      /** How far each edge alone may slip, ticks; null: not measured for the level as it is. */
      readonly slack: number | null;
      /** All edges at once; null: not measured for the level as it is. */
      readonly certified: { readonly ticks: number; readonly exhausted: boolean } | null;
      /** Whether the change is over, and nothing more is sought for this run. */
      readonly isFinal: boolean;
      /** null: not known yet */
      readonly others: Surviving | null;
    }
  | {
      readonly kind: 'failed';
      readonly run: string;
      /** No press or release was shifted farther than this, ticks. */
      readonly within: number;
      /** Whether all was tried that is tried. */
      readonly isWhole: boolean;
      readonly isFinal: boolean;
      readonly others: Surviving | null;
    }
  /** Only other runs had to be kept alive. */
  | { readonly kind: 'others'; readonly others: Surviving };

/** What was done last to keep the shown run of a level alive. */
export const aliveOf = ofDocument(() => createStore<AliveState>(() => ({ kind: 'idle' })));

const survivingInWords = (others: Surviving | null): string =>
  others === null || others.of < 2 ? '' : `; ${others.complete} of ${others.of} runs complete the level`;

/** What was done to keep the shown run alive, as a part of a sentence; null: nothing had to be done. */
export function aliveInWords(state: AliveState): string | null {
  switch (state.kind) {
    case 'idle':
      return null;
    case 'working':
      return 're-timing…';
    case 'others':
      return `kept alive: ${state.others.complete} of ${state.others.of} runs complete the level`;
    case 'failed': {
      const what = state.isWhole ? 'not' : 'nothing found';
      return `${what} within ${plural(state.within, 'tick')} of the old holds${survivingInWords(state.others)}`;
    }
    case 'alive': {
      const { edges, most, lost, certified, slack, others } = state;
      const by = `${edges === 1 ? 'by' : 'at most'} ${plural(most, 'tick')}`;
      const moved = edges === 0 ? 'with the old holds' : `${plural(edges, 'edge')} moved${edges === 1 ? '' : ','} ${by}`;
      const forgives =
        certified !== null
          ? `; certified ${certified.exhausted ? 'at least ' : ''}${plural(certified.ticks, 'tick')}`
          : slack !== null
            ? `; slack ${plural(slack, 'tick')}`
            : '';
      const without = lost === 0 ? '' : `; ${plural(lost, 'mineral')} fewer`;
      return `kept alive: ${moved}${forgives}${without}${survivingInWords(others)}`;
    }
  }
}
