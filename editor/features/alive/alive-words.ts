import { plural } from '../../../check/words/index.ts';
import type { AliveState, Surviving } from './alive-state.ts';

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
