import { nameOf } from '../document/index.ts';
import type { Leeway, Reach } from '../workers/index.ts';
import type { LeewayFindings } from './leeway-store.ts';
import { objectsAsked, type Question } from './question.ts';

const number = (px: number): string => String(Number(px.toFixed(2)));

/** The names of the places of an object that has several. */
export const PLACE_NAMES = ['entrance', 'exit'] as const;

/** What is moved: `Asteroid 2`, `Entrance of wormhole 1`, `3 objects, moved together`. */
export function movedInWords(question: Pick<Question, 'file' | 'keys' | 'only'>): string {
  const objects = objectsAsked(question);
  if (objects.length !== 1) return `${objects.length} objects, moved together`;
  const name = nameOf(objects[0]);
  const { only } = question;
  if (only === null) return name;
  const place = PLACE_NAMES[only] ?? `place ${only + 1}`;
  return `${place.charAt(0).toUpperCase()}${place.slice(1)} of ${name.toLowerCase()}`;
}

const WAYS = { left: 'left', right: 'right', up: 'up', down: 'down' } as const;

function freeInWords({ direction, same, isEnd }: Reach): string {
  const way = WAYS[direction];
  if (!isEnd) return `${way} ${same} px or more`;
  return same === 0 ? `${way} not at all` : `${way} ${same} px`;
}

function neededInWords({ direction, same, isEnd }: Reach): string {
  const way = WAYS[direction];
  return isEnd ? `${way} by ${same + 1} px` : `${way} not within ${same} px`;
}

/** How far it may go in each direction, simulated px by px; null: not known yet. */
export function reachInWords({ base, reach, isReachKnown }: Pick<Leeway, 'base' | 'reach' | 'isReachKnown'>): string | null {
  if (base === null || base === 'unknown' || !isReachKnown) return null;
  return base === 'completes'
    ? `It may go ${reach.map(freeInWords).join(', ')}.`
    : `The run would complete the level when it goes ${reach.map(neededInWords).join(', ')}.`;
}

/** How finely it is sampled now. */
export function samplingInWords({ answer, phase }: Pick<LeewayFindings, 'answer' | 'phase'>): string {
  if (answer === null) return '';
  const { every, atEdges, isCovered, isFinished, lattice } = answer.leeway;
  const isGrid = answer.question.grid !== null && every <= lattice.base * lattice.unit;
  const isRefining = phase !== 'done' && !isFinished;
  const often = isGrid ? `at every place of the grid (${number(every)} px)` : `every ${number(every)} px`;
  const edges = atEdges > 0 && atEdges < every ? `, at edges every ${number(atEdges)} px` : '';
  const rest = isCovered ? '' : '; dotted: not sampled yet';
  return `Sampled ${every > 0 ? often : `every ${number(atEdges)} px`}${every > 0 ? edges : ''}${rest}${isRefining ? '; refining…' : '.'}`;
}

/** What keeps it from being known, or what it is about; '' if nothing needs to be said. */
export function noteInWords({ phase, message, answer }: LeewayFindings): string {
  switch (phase) {
    case 'off':
      return '';
    case 'nothing selected':
      return 'Select an object to see where it may stand.';
    case 'too large':
      return `Not sampled: ${message ?? 'the run takes too much work'}.`;
    case 'failed':
      return `Failed: ${message}. Hide and show it to try again.`;
    default:
      return answer === null ? 'Sampling where it may stand…' : '';
  }
}

/** What the shade means for this run. */
export function meaningInWords({ question, leeway }: NonNullable<LeewayFindings['answer']>): string {
  const run = question.run === null ? 'she, without a run,' : `the run ${question.run}`;
  return leeway.base === 'fails'
    ? `${run.charAt(0).toUpperCase()}${run.slice(1)} fails as it is: there is no place to keep. Hatched: where it would complete the level.`
    : `Hatched: where ${run} still completes the level.`;
}
